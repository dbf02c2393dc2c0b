// SPDX-License-Identifier: Apache-2.0

// The lit preview: shows the maps of a material on a plane, a sphere or a cylinder, with WebGL 2.

import {attachControls} from "./surface_controls.js";
import {directionTo, movedLight} from "./surface_light.js";
import {kShapes, meshOf} from "./surface_mesh.js";
import {Fence, linked, suitableQuality, uniformsOf, uploaded} from "./surface_program.js";
import {kFragmentShader, kVertexShader} from "./surface_shaders.js";
import {checkImage, Textures} from "./surface_textures.js";
import {View} from "./surface_view.js";

const kSamplers = ["base_color", "normal", "height", "data", "emission"];
const kImages = ["baseColor", "normal", "height", "roughness", "occlusion", "metallic", "emission"];
const kQualities = {
    full: {antialias: true, anisotropy: 8, shadowSteps: 12, cells: 660, pixelRatio: 2, samplesAtRest: 1},
    fast: {antialias: false, anisotropy: 1, shadowSteps: 5, cells: 324, pixelRatio: 1, samplesAtRest: 4},
};
const kSmoothing = 1;  // heights are read this many mip levels above the level with one texel per cell of the mesh
const kRest = 250;  // milliseconds without a change after which the picture is drawn with more samples
const kMaxMilliseconds = 1500;  // a picture that takes more milliseconds gets no further samples
const kMaxSamples = 4e6;  // largest number of samples of a picture, unless it has one per pixel
const kNoWebGl = "The lit preview needs WebGL 2, which this browser does not offer or has turned off.";

// Draws on a canvas whenever something changed. After the user has moved the light, the canvas gets the event
// "lightchange" with {azimuth, elevation} in `detail`.
export class Surface {
    // `quality` is "full", "fast" (for a computer without a graphics card) or "auto". Throws an Error if the browser
    // has no WebGL 2.
    constructor(canvas, {quality = "auto"} = {}) {
        this.canvas = canvas;
        this.quality = kQualities[quality === "auto" ? suitableQuality() : quality];
        this.gl = canvas.getContext("webgl2", {alpha: false, antialias: this.quality.antialias});
        if (!this.gl) {
            throw new Error(kNoWebGl);
        }
        this.images = {};
        this.shape = "plane";
        this.tiling = 1;
        this.light = {azimuth: 135, elevation: 50};
        this.lightStrength = 0.85;
        this.ambient = 0.4;
        this.relief = 1;
        this.normalDirection = "gl";
        this.background = [0.17, 0.18, 0.2];
        this.view = new View(this.shape);
        this.frame = 0;
        this.build();
        this.listen();
    }

    // Each image is {width, height, data}, or null if there is no such map. Rows go from the top to the bottom, and
    // `data` are bytes R G B A. Colors are sRGB; where alpha of the base color is 0, the background is visible. `data`
    // of the image `height` may also be a Float32Array with one number per pixel. The image `height` may have a member
    // `unit`: the number of tile widths that the number 1 (or the code 255) stands for, by default 1 for floats and
    // 0.05 for bytes. Without the image `normal`, normals are computed from the image `height`. An image that is
    // the same object as before is not sent to the graphics card again. Throws an Error if an image is too large or its
    // data have the wrong length.
    setImages(images) {
        const largest = this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE) ?? Infinity;  // null if the context is lost
        for (const name of kImages) {
            checkImage(name, images[name], largest);
        }
        this.images = Object.fromEntries(kImages.map((name) => [name, images[name] ?? null]));
        this.imagesChanged = true;
        this.invalidate();
    }

    // Shows another shape, "plane", "sphere" or "cylinder", in its default view.
    setShape(shape) {
        if (!(shape in kShapes)) {
            throw new Error(`There is no shape "${shape}"; allowed are ${Object.keys(kShapes).join(", ")}.`);
        }
        if (shape !== this.shape) {
            this.shape = shape;
            this.view.setShape(shape);
            this.meshChanged = true;
            this.invalidate();
        }
    }

    // Sets the number of tiles along the side of the plane, or along the visible half of the other shapes: 1, 2, ...
    setTiling(tiling) {
        this.set("tiling", Math.max(Math.round(tiling), 1));
    }

    // Sets the direction to the light in degrees, as in the map `lit`: the azimuth, counterclockwise from the right,
    // and the elevation above the plane. At elevation 0 a round shape is lit from the side, at 90 from the front.
    setLight({azimuth, elevation}) {
        this.set("light", {azimuth, elevation});
    }

    // Sets the brightness of a white, rough surface that faces the light. The default is 0.85.
    setLightStrength(strength) {
        this.set("lightStrength", strength);
    }

    // Sets the brightness of a white surface that faces the middle of the sky. The default is 0.4.
    setAmbient(ambient) {
        this.set("ambient", ambient);
    }

    // Sets the factor on the heights and on the slopes of the normals.
    setRelief(scale) {
        this.set("relief", scale);
    }

    // Sets the direction in which green is positive: "gl" is up, "dx" is down.
    setNormalDirection(direction) {
        this.set("normalDirection", direction);
    }

    // Sets the background: any opaque color of CSS.
    setBackground(cssColor) {
        const painter = document.createElement("canvas").getContext("2d");
        painter.fillStyle = cssColor;
        painter.fillRect(0, 0, 1, 1);
        this.set("background", [...painter.getImageData(0, 0, 1, 1).data.slice(0, 3)].map((code) => code / 255));
    }

    // Shows the default view of the shape.
    resetView() {
        this.view.reset();
        this.invalidate();
    }

    // Draws now, so that pixels can be read from the canvas in the same task. After a change, no
    // call is needed: the browser calls this function before it shows the canvas again.
    render() {
        cancelAnimationFrame(this.frame);
        clearTimeout(this.timer);
        this.frame = 0;
        this.draw(Math.min(window.devicePixelRatio || 1, this.quality.pixelRatio));
        if (this.quality.samplesAtRest > 1) {
            this.timer = setTimeout(() => this.refine(), kRest);
        }
    }

    // Draws with several samples per pixel, unless one sample per pixel has already taken too long.
    // The browser computes the mean of the samples when it shows the canvas.
    refine() {
        if (!this.fence.isPassed()) {
            this.timer = setTimeout(() => this.refine(), kRest);
        } else if (this.fence.milliseconds < kMaxMilliseconds) {
            const area = this.canvas.clientWidth * this.canvas.clientHeight;
            this.draw(Math.sqrt(Math.min(this.quality.samplesAtRest, Math.max(kMaxSamples / area, 1))));
        }
    }

    // Draws now. `ratio` is the number of pixels of the canvas per pixel of CSS.
    draw(ratio) {
        const gl = this.gl;
        if (this.disposed || gl.isContextLost() || !this.resize(ratio)) {
            return;
        }
        this.update();
        gl.viewport(0, 0, this.canvas.width, this.canvas.height);
        gl.clearColor(...this.background, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.useProgram(this.program);
        this.setUniforms();
        this.textures.bind(kSamplers);
        gl.bindVertexArray(this.mesh.array);
        gl.drawElements(gl.TRIANGLES, this.mesh.indexCount, gl.UNSIGNED_INT, 0);
        this.fence.set();
    }

    // Frees the memory of the graphics card. The canvas cannot be used for another Surface.
    dispose() {
        cancelAnimationFrame(this.frame);
        clearTimeout(this.timer);
        this.disposed = true;
        this.resizes.disconnect();
        this.detachControls();
        this.stop.abort();
        this.textures.dispose();
        this.deleteMesh();
        this.gl.deleteProgram(this.program);
    }

    set(name, value) {
        this[name] = value;
        this.invalidate();
    }

    invalidate() {
        if (!this.frame && !this.disposed) {
            this.frame = requestAnimationFrame(() => this.renderIfIdle());
        }
    }

    // Waits until the last picture is finished, so that pictures do not queue up.
    renderIfIdle() {
        this.frame = 0;
        if (this.fence.isPassed()) {
            this.render();
        } else {
            this.invalidate();
        }
    }

    listen() {
        const canvas = this.canvas;
        this.stop = new AbortController();
        const options = {signal: this.stop.signal};
        canvas.addEventListener("webglcontextlost", (event) => event.preventDefault(), options);
        canvas.addEventListener("webglcontextrestored", () => {
            this.build();
            this.invalidate();
        }, options);
        this.resizes = new ResizeObserver(() => this.invalidate());
        this.resizes.observe(canvas);
        const then = (action) => (...values) => {
            action(...values);
            this.invalidate();
        };
        this.detachControls = attachControls(canvas, {
            orbit: then((turn, tilt) => this.view.orbit(turn, tilt)),
            zoom: then((factor, at) => this.view.zoomBy(factor, at)),
            reset: then(() => this.view.reset()),
            light: (x, y) => this.moveLight(x, y),
        });
    }

    moveLight(x, y) {
        this.setLight(movedLight(this.light, x, y));
        this.canvas.dispatchEvent(new CustomEvent("lightchange", {detail: {...this.light}}));
    }

    // Returns false if the canvas is not visible.
    resize(ratio) {
        const width = Math.round(this.canvas.clientWidth * ratio);
        const height = Math.round(this.canvas.clientHeight * ratio);
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        return width > 0 && height > 0;
    }

    // Creates all objects of the WebGL context: at the start, and after a lost context was restored.
    build() {
        const gl = this.gl;
        this.program = linked(gl, kVertexShader, kFragmentShader);
        this.uniforms = uniformsOf(gl, this.program);
        this.fence = new Fence(gl);
        this.textures = new Textures(gl, this.quality.anisotropy);
        this.mesh = null;
        this.meshChanged = true;
        this.imagesChanged = true;
        gl.enable(gl.DEPTH_TEST);
        gl.enable(gl.CULL_FACE);
    }

    update() {
        if (this.imagesChanged) {
            this.heights = this.textures.update(this.images);
            this.imagesChanged = false;
        }
        if (this.meshChanged) {
            this.deleteMesh();
            this.mesh = uploaded(this.gl, this.program, meshOf(this.shape, this.quality.cells));
            this.meshChanged = false;
        }
    }

    deleteMesh() {
        if (this.mesh) {
            this.gl.deleteVertexArray(this.mesh.array);
            this.mesh.buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
            this.mesh = null;
        }
    }

    setUniforms() {
        const {gl, uniforms, view, mesh, heights} = this;
        const aspect = this.canvas.width / this.canvas.height;
        const repeat = mesh.tiles * this.tiling;
        const texelsPerCell = heights.heightWidth * repeat / mesh.cellsPerTurn;
        gl.uniformMatrix3fv(uniforms.u_turn, false, view.turnMatrix());
        gl.uniformMatrix4fv(uniforms.u_projection, false, view.projection(aspect));
        gl.uniform3fv(uniforms.u_camera, view.cameraPosition(aspect));
        gl.uniform3fv(uniforms.u_light, directionTo(this.light));
        gl.uniform3fv(uniforms.u_sky, view.shape.sky);
        gl.uniform3fv(uniforms.u_background, this.background);
        gl.uniform1f(uniforms.u_strength, this.lightStrength);
        gl.uniform1f(uniforms.u_ambient, this.ambient);
        gl.uniform1f(uniforms.u_repeat, repeat);
        gl.uniform1f(uniforms.u_origin, this.shape === "plane" ? this.tiling / 2 : 0.5);
        gl.uniform1f(uniforms.u_tile_width, mesh.tileWidth / this.tiling);
        gl.uniform1f(uniforms.u_height_scale, heights.heightUnit * this.relief);
        gl.uniform1f(uniforms.u_height_top, heights.heightTop * this.relief);
        gl.uniform1f(uniforms.u_height_middle, heights.heightTop * this.relief * view.shape.middle);
        gl.uniform1f(uniforms.u_shadow_steps, this.quality.shadowSteps);
        gl.uniform1f(uniforms.u_height_lod, Math.max(Math.log2(texelsPerCell) + kSmoothing, 0));
        gl.uniform2f(uniforms.u_slopes, this.relief, this.normalDirection === "dx" ? -this.relief : this.relief);
        kSamplers.forEach((name, unit) => gl.uniform1i(uniforms[`u_${name}`], unit));
    }
}
