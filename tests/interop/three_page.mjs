// SPDX-License-Identifier: Apache-2.0
//
// Runs in the browser: draws mip levels of textures with three.js, one texel per pixel, and returns the pixels. Pixels are
// four numbers from 0 to 255, from the top left pixel on. three.mjs calls these functions.

import { decompress } from "fzstd";
import { read } from "ktx-parse";
import * as THREE from "three";
import { DDSLoader } from "three/addons/loaders/DDSLoader.js";
import { KTX2Loader } from "three/addons/loaders/KTX2Loader.js";

const renderer = new THREE.WebGLRenderer();
const loader = new KTX2Loader().detectSupport(renderer);
loader.init = async () => {}; // starts workers for Basis Universal, which no file of foamtex contains

export function renderer_name() {
    const gl = renderer.getContext();
    return gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL);
}

// The fragment shader reads the middle of one texel. WebGL counts rows from the bottom, a texture here from the top.
// Colors of sRGB textures are linear light in a shader, and are encoded again.
function fragment_shader(sampler, sample, is_color) {
    return `
        precision highp ${sampler};
        uniform ${sampler} image;
        uniform vec2 size;
        uniform float layer;
        uniform float level;
        out vec4 pixel;
        void main() {
            vec2 uv = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y) / size;
            pixel = ${sample};
            ${is_color ? "pixel.rgb = mix(12.92 * pixel.rgb, 1.055 * pow(pixel.rgb, vec3(1.0 / 2.4)) - 0.055, "
                         + "step(0.0031308, pixel.rgb));" : ""}
        }`;
}

function draw(texture, sampler, sample, { width, height, layer = 0, level = 0 }) {
    const size = [Math.max(1, width >> level), Math.max(1, height >> level)];
    texture.minFilter = texture.mipmaps?.length > 1 ? THREE.NearestMipmapNearestFilter : THREE.NearestFilter;
    texture.magFilter = THREE.NearestFilter;
    texture.needsUpdate = true;
    const material = new THREE.ShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: {
            image: { value: texture },
            size: { value: size },
            layer: { value: layer },
            level: { value: level },
        },
        vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
        fragmentShader: fragment_shader(sampler, sample, texture.colorSpace === THREE.SRGBColorSpace),
    });
    const scene = new THREE.Scene().add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
    renderer.setSize(...size, false);
    renderer.render(scene, new THREE.Camera());
    const gl = renderer.getContext();
    const rows = new Uint8Array(4 * size[0] * size[1]);
    gl.readPixels(0, 0, ...size, gl.RGBA, gl.UNSIGNED_BYTE, rows);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) {
        throw new Error(`WebGL reports error ${error}`);
    }
    return from_top(rows, 4 * size[0]);
}

// Reverses the order of the rows.
function from_top(rows, row_bytes) {
    const pixels = [];
    for (let at = rows.length - row_bytes; at >= 0; at -= row_bytes) {
        pixels.push(...rows.subarray(at, at + row_bytes));
    }
    return pixels;
}

async function bytes_at(url) {
    return new Uint8Array(await (await fetch(url)).arrayBuffer());
}

// Draws a mip level of a single texture that KTX2Loader reads.
export async function draw_single(url, level) {
    const texture = await loader.loadAsync(url);
    return draw(texture, "sampler2D", "textureLod(image, uv, level)", { ...texture.image, level });
}

// Returns the message with which KTX2Loader rejects a file, or whether it reads the file as an array.
export async function loader_verdict(url) {
    try {
        const texture = await loader.loadAsync(url);
        return texture.isCompressedArrayTexture === true ? "array" : "single";
    } catch (error) {
        return error.message;
    }
}

const array_formats = {
    139: [THREE.RED_RGTC1_Format, THREE.NoColorSpace],
    141: [THREE.RED_GREEN_RGTC2_Format, THREE.NoColorSpace],
    145: [THREE.RGBA_BPTC_Format, THREE.NoColorSpace],
    146: [THREE.RGBA_BPTC_Format, THREE.SRGBColorSpace],
};

// Draws a mip level of a layer of a compressed array texture.
export async function draw_layer(url, layer, level) {
    const file = read(await bytes_at(url));
    const [format, color_space] = array_formats[file.vkFormat];
    const size = { width: file.pixelWidth, height: file.pixelHeight };
    const mipmaps = file.levels.map((mip, k) => ({
        data: decompress(mip.levelData),
        width: Math.max(1, size.width >> k),
        height: Math.max(1, size.height >> k),
    }));
    const texture = new THREE.CompressedArrayTexture(mipmaps, size.width, size.height, file.layerCount, format);
    texture.colorSpace = color_space;
    return draw(texture, "sampler2DArray", "textureLod(image, vec3(uv, layer), level)", { ...size, layer, level });
}

// Draws the full size of a layer of an array of integers of 16 bits, which WebGL 2 cannot scale to 0 to 1 itself.
export async function draw_layer_of_integers(url, layer) {
    const file = read(await bytes_at(url));
    const size = { width: file.pixelWidth, height: file.pixelHeight };
    const codes = new Uint16Array(decompress(file.levels[0].levelData).slice().buffer);
    const texture = new THREE.DataArrayTexture(codes, size.width, size.height, file.layerCount);
    texture.format = THREE.RedIntegerFormat;
    texture.type = THREE.UnsignedShortType;
    texture.internalFormat = "R16UI";
    texture.unpackAlignment = 1;
    const sample = "vec4(float(texture(image, vec3(uv, layer)).r) / 65535.0, 0.0, 0.0, 1.0)";
    return draw(texture, "usampler2DArray", sample, { ...size, layer });
}

// Returns true if DDSLoader reads a file.
export async function dds_loader_reads(url) {
    return new DDSLoader().parse((await bytes_at(url)).buffer, true).format !== null;
}

// Returns the pixels of a PNG and its width, as the browser decodes it. A canvas would premultiply colors by alpha.
export async function png_pixels(url) {
    const blob = await (await fetch(url)).blob();
    const image = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    const texture = new THREE.Texture(image);
    texture.generateMipmaps = false;
    return { width: image.width, pixels: draw(texture, "sampler2D", "texture(image, uv)", image) };
}
