// SPDX-License-Identifier: Apache-2.0

// Mouse, pen, touch, and Shift with arrow keys on the picture: pan, zoom, and the point under the pointer.

import {Signal} from "./signal.js";
import {wheelPixels} from "./dom.js";

const kClick = 4; // CSS pixels that the pointer may move during a click
const kArrow = 40; // CSS pixels for a press of an arrow key
const kArrows = {ArrowLeft: [kArrow, 0], ArrowRight: [-kArrow, 0], ArrowUp: [0, kArrow], ArrowDown: [0, -kArrow]};

export class ViewGestures {
    /** Emits the point under the pointer as fractions of the tile, or null if the pointer is not over the picture. */
    hovered = new Signal();
    /** Emits the point of a click as fractions of the tile. */
    clicked = new Signal();

    #canvas;
    #view;
    #pointers = new Map();
    #travel = 0;

    constructor(canvas, view) {
        this.#canvas = canvas;
        this.#view = view;
        canvas.addEventListener("wheel", (event) => this.#wheel(event), {passive: false});
        canvas.addEventListener("pointerdown", (event) => this.#down(event));
        canvas.addEventListener("pointermove", (event) => this.#move(event));
        canvas.addEventListener("pointerup", (event) => this.#up(event));
        canvas.addEventListener("pointercancel", (event) => this.#pointers.delete(event.pointerId));
        canvas.addEventListener("pointerleave", () => this.hovered.emit(null));
        canvas.addEventListener("dblclick", () => view.fit());
        canvas.addEventListener("keydown", (event) => this.#key(event));
    }

    #wheel(event) {
        event.preventDefault();
        this.#view.zoomBy(Math.exp(-wheelPixels(event) * 0.002), event.offsetX, event.offsetY);
    }

    #down(event) {
        if (event.button > 1) {
            return;
        }
        this.#canvas.setPointerCapture(event.pointerId);
        this.#pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
        this.#travel = 0;
    }

    #move(event) {
        const last = this.#pointers.get(event.pointerId);
        const now = [event.offsetX, event.offsetY];
        if (!last) {
            this.hovered.emit(this.#view.pointAt(...now));
            return;
        }
        this.#travel += Math.hypot(now[0] - last[0], now[1] - last[1]);
        if (this.#pointers.size === 2) {
            this.#pinch(event.pointerId, now);
        } else if (this.#travel > kClick) {
            this.#canvas.classList.add("panning");
            this.#view.pan(now[0] - last[0], now[1] - last[1]);
        }
        this.#pointers.set(event.pointerId, now);
    }

    #pinch(moved, now) {
        const fixed = [...this.#pointers].find(([id]) => id !== moved)[1];
        const last = this.#pointers.get(moved);
        const distance = (point) => Math.hypot(point[0] - fixed[0], point[1] - fixed[1]);
        this.#view.zoomBy(distance(now) / Math.max(1, distance(last)), ...fixed);
    }

    #up(event) {
        const wasDown = this.#pointers.delete(event.pointerId);
        this.#canvas.classList.remove("panning");
        const point = this.#view.pointAt(event.offsetX, event.offsetY);
        if (wasDown && this.#travel <= kClick && point) {
            this.clicked.emit(point);
        }
    }

    #key(event) {
        const step = kArrows[event.key];
        if (step && event.shiftKey) {
            event.preventDefault();
            event.stopPropagation();
            this.#view.pan(...step);
        }
    }
}
