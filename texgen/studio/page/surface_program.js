// SPDX-License-Identifier: Apache-2.0

// The WebGL program (the linked shaders) of the lit preview, and the preview's meshes on the graphics card.

import {kFloatsPerVertex} from "./surface_mesh.js";

const kSoftwareRenderers = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const kAttributes = {a_position: 3, a_normal: 3, a_tangent: 3, a_uv: 2, a_rise: 2};

// Returns "fast" if the processor has to do the work of a graphics card, else "full".
export function suitableQuality() {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) {
        return "full";
    }
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const renderer = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return kSoftwareRenderers.test(renderer) ? "fast" : "full";
}

// Tells when the graphics card has finished a picture, and how long this took.
export class Fence {
    constructor(gl) {
        this.gl = gl;
        this.sync = null;
        this.milliseconds = 0;  // from `set` until `isPassed` finds that the picture is finished
    }

    // Call this function after the commands that draw a picture.
    set() {
        this.gl.deleteSync(this.sync);
        this.sync = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        this.start = performance.now();
        this.gl.flush();
    }

    // Returns true if all pictures are finished. The browser updates the answer between tasks.
    isPassed() {
        const gl = this.gl;
        if (this.sync && (gl.isContextLost() || gl.getSyncParameter(this.sync, gl.SYNC_STATUS) === gl.SIGNALED)) {
            this.milliseconds = performance.now() - this.start;
            gl.deleteSync(this.sync);
            this.sync = null;
        }
        return !this.sync;
    }
}

function compiled(gl, type, source) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(`A shader of the lit preview does not compile: ${gl.getShaderInfoLog(shader)}`);
    }
    return shader;
}

// Returns the WebGL program of two shaders. Throws an Error if they cannot be compiled or linked.
export function linked(gl, vertexSource, fragmentSource) {
    const program = gl.createProgram();
    const shaders = [compiled(gl, gl.VERTEX_SHADER, vertexSource), compiled(gl, gl.FRAGMENT_SHADER, fragmentSource)];
    shaders.forEach((shader) => gl.attachShader(program, shader));
    gl.linkProgram(program);
    shaders.forEach((shader) => gl.deleteShader(shader));
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
        throw new Error(`The shaders of the lit preview cannot be linked: ${gl.getProgramInfoLog(program)}`);
    }
    return program;
}

// Returns the locations of the uniforms of a program, by name.
export function uniformsOf(gl, program) {
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0;
    const names = Array.from({length: count}, (_, k) => gl.getActiveUniform(program, k).name);
    return Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)]));
}

// Sends a mesh (meshOf) to the graphics card. Returns its vertex array, its buffers, the number of indices, and the
// other properties of the mesh.
export function uploaded(gl, program, {vertices, indices, ...measures}) {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffers = [gl.createBuffer(), gl.createBuffer()];
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    let offset = 0;
    for (const [name, size] of Object.entries(kAttributes)) {
        const location = gl.getAttribLocation(program, name);
        if (location >= 0) {
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, size, gl.FLOAT, false, kFloatsPerVertex * 4, offset * 4);
        }
        offset += size;
    }
    gl.bindVertexArray(null);
    return {array, buffers, indexCount: indices.length, ...measures};
}
