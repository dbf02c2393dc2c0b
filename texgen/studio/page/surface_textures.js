// SPDX-License-Identifier: Apache-2.0

// Textures of the lit preview (surface.js), which shows the maps of a material on a shape under a light.

// Images that replace maps that are null. Together they show a gray surface without relief.
const kNoImage = {
    baseColor: {width: 1, height: 1, data: new Uint8ClampedArray([160, 160, 160, 255])},
    normal: {width: 1, height: 1, data: new Uint8ClampedArray([128, 128, 255, 255])},
    emission: {width: 1, height: 1, data: new Uint8ClampedArray([0, 0, 0, 255])},
};
const kNoHeight = {width: 1, height: 1, data: new Float32Array([0])};
const kNoData = {occlusion: 255, roughness: 140, metallic: 0};
const kUnitOfCodes = 0.05;  // default of the member `unit` of a height image of 8 bits (Surface.setImages)

// The textures of the five samplers of the shaders. An image that is the same object as before is not sent to the
// graphics card again, so each frame of a loop must be a new object.
export class Textures {
    // `anisotropy` is the largest number of samples that anisotropic filtering takes per pixel; 1 turns it off.
    constructor(gl, anisotropy) {
        this.gl = gl;
        this.slots = {};
        this.anisotropic = anisotropy > 1 ? gl.getExtension("EXT_texture_filter_anisotropic") : null;
        this.anisotropy = anisotropy;
        this.halfFloatMips = Boolean(gl.getExtension("EXT_color_buffer_float") ||
                                     gl.getExtension("EXT_color_buffer_half_float"));
    }

    // Sends the images to the graphics card. Returns {heightUnit, heightTop, heightWidth}: the
    // number of tile widths that the height 1 stands for, the largest height in tile widths, and
    // the width of the height map in pixels.
    update(images) {
        const gl = this.gl;
        const colors = {internal: gl.SRGB8_ALPHA8, format: gl.RGBA, type: gl.UNSIGNED_BYTE, mips: true};
        const linear = {...colors, internal: gl.RGBA8};
        const heights = {internal: gl.R16F, format: gl.RED, type: gl.FLOAT, mips: this.halfFloatMips};
        this.send("base_color", images.baseColor ?? kNoImage.baseColor, colors);
        this.send("emission", images.emission ?? kNoImage.emission, colors);
        this.send("normal", images.normal ?? normalsOfHeight(images.height) ?? kNoImage.normal, linear);
        this.sendHeight(images.height, heights);
        this.sendData(images, linear);
        return this.height;
    }

    sendData(images, format) {
        const key = [images.occlusion, images.roughness, images.metallic, images.height];
        if (!this.dataKey || key.some((image, k) => image !== this.dataKey[k])) {
            this.send("data", packed(images, this.height), format);
            this.dataKey = key;
        }
    }

    sendHeight(image, format) {
        if (this.heightKey !== image || !this.height) {
            const height = image ? asFloats(image) : {...kNoHeight, unit: 0};
            this.send("height", height, format);
            const top = height.data.reduce((largest, value) => Math.max(largest, value), 0) * height.unit;
            this.height = {heightUnit: height.unit, heightTop: top, heightWidth: height.width};
            this.heightKey = image;
        }
    }

    send(name, image, {internal, format, type, mips}) {
        const gl = this.gl;
        const slot = this.slots[name] ??= {texture: gl.createTexture()};
        if (slot.image === image) {
            return;
        }
        gl.bindTexture(gl.TEXTURE_2D, slot.texture);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        const {width, height} = image;
        if (slot.image?.width === width && slot.image?.height === height) {
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, image.data);
        } else {
            gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, image.data);
            this.setFilter(mips);
        }
        if (mips) {
            gl.generateMipmap(gl.TEXTURE_2D);
        }
        slot.image = image;
    }

    setFilter(mips) {
        const gl = this.gl;
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, mips ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
        if (this.anisotropic && mips) {
            const largest = gl.getParameter(this.anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT);
            const samples = Math.min(largest, this.anisotropy);
            gl.texParameterf(gl.TEXTURE_2D, this.anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, samples);
        }
    }

    // Binds the textures to the texture units 0, 1, ... in the order of `names`.
    bind(names) {
        names.forEach((name, unit) => {
            this.gl.activeTexture(this.gl.TEXTURE0 + unit);
            this.gl.bindTexture(this.gl.TEXTURE_2D, this.slots[name].texture);
        });
    }

    dispose() {
        for (const slot of Object.values(this.slots)) {
            this.gl.deleteTexture(slot.texture);
        }
        this.slots = {};
    }
}

// Throws an Error if the number of samples in `image` does not fit its width and height, or if one of these exceeds
// `largest`. `image` may be null.
export function checkImage(name, image, largest) {
    if (image == null) {
        return;
    }
    const {width, height, data} = image;
    const samples = width * height * (data instanceof Float32Array ? 1 : 4);
    if (!(width > 0 && height > 0) || data?.length !== samples) {
        throw new Error(`The image ${name} has ${data?.length} samples; ${width} x ${height} pixels need ${samples}.`);
    }
    if (width > largest || height > largest) {
        throw new Error(`The image ${name} has ${width} x ${height} pixels; this graphics card allows ${largest}.`);
    }
}

// Returns the height as numbers, with `unit`: the number of tile widths that the number 1 stands
// for.
function asFloats(image) {
    const {width, height, data} = image;
    if (data instanceof Float32Array) {
        return {width, height, data, unit: image.unit ?? 1};
    }
    const numbers = Float32Array.from({length: width * height}, (_, k) => data[4 * k] / 255);
    return {width, height, data: numbers, unit: image.unit ?? kUnitOfCodes};
}

// Returns an image with the maps occlusion, roughness and metallic in its channels R, G and B, and
// in A the height as a fraction of the largest height. `heightInfo` is the result of
// Textures.update. The image has the size of the largest map; the pixels of smaller maps are
// repeated.
function packed(images, heightInfo) {
    const channels = Object.entries(kNoData).map(([name, code]) => codesOf(images[name], code));
    channels.push(codesOf(images.height, 0, heightInfo.heightTop / heightInfo.heightUnit));
    const width = Math.max(...channels.map((channel) => channel.width));
    const height = Math.max(...channels.map((channel) => channel.height));
    const data = new Uint8ClampedArray(width * height * 4);
    channels.forEach((channel, k) => {
        for (let y = 0; y < height; ++y) {
            const row = Math.floor(y * channel.height / height) * channel.width;
            for (let x = 0; x < width; ++x) {
                const pixel = row + Math.floor(x * channel.width / width);
                data[(y * width + x) * 4 + k] = channel.data[channel.stride * pixel] * channel.scale;
            }
        }
    });
    return {width, height, data};
}

// Describes the samples of a gray image: a sample times `scale` is a code of 8 bits. The code 255
// stands for the number `largest`; in an image of bytes, the byte b is the number b / 255. An image
// that is null is replaced by one pixel of the code `code`.
function codesOf(image, code, largest = 1) {
    if (!image) {
        return {width: 1, height: 1, data: [code], stride: 1, scale: 1};
    }
    const {width, height, data} = image;
    const floats = data instanceof Float32Array;
    return {width, height, data, stride: floats ? 1 : 4, scale: floats ? 255 / (largest || 1) : 1 / (largest || 1)};
}

// Returns the normals of a height map, which must tile. Returns null if the height map is null.
function normalsOfHeight(image) {
    if (!image) {
        return null;
    }
    const {width, height, data, unit} = asFloats(image);
    const normals = new Uint8ClampedArray(width * height * 4).fill(255);
    for (let y = 0; y < height; ++y) {
        const above = (y + height - 1) % height * width;
        const below = (y + 1) % height * width;
        for (let x = 0; x < width; ++x) {
            const row = y * width;
            const slopeX = (data[row + (x + 1) % width] - data[row + (x + width - 1) % width]) * unit * width / 2;
            const slopeY = (data[above + x] - data[below + x]) * unit * width / 2;
            const scale = 127.5 / Math.hypot(slopeX, slopeY, 1);
            normals.set([127.5 - slopeX * scale, 127.5 - slopeY * scale, 127.5 + scale], 4 * (row + x));
        }
    }
    return {width, height, data: normals};
}
