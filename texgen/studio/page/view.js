// SPDX-License-Identifier: Apache-2.0

// The picture on its canvas: tiles, pan and zoom. For comparison, an earlier picture can be shown to the left of a
// dividing line.

import {Signal} from "./signal.js";
import {ViewGestures} from "./view_gestures.js";
import {clamp} from "./dom.js";

const kMargin = 24; // CSS pixels around a picture that fits
const kMaxZoom = 64; // CSS pixels per pixel of the images (View.size)
const kSmoothBelow = 2; // a pixel of the picture that is at least this many device pixels wide is drawn as a square
// If the shorter side of the canvas has at most this many device pixels, pictures 512 pixels wide are sharp enough.
const kSmallCanvas = 900;
const kChecker = 8; // CSS pixels of a square behind transparent pictures

// A picture on a canvas that is not part of the page. From there it is drawn, scaled, on the visible canvas.
class Layer {
    canvas = document.createElement("canvas");
    picture = null;

    show(picture) {
        this.picture = picture;
        if (this.canvas.width !== picture.width || this.canvas.height !== picture.height) {
            this.canvas.width = picture.width;
            this.canvas.height = picture.height;
        }
        this.canvas.getContext("2d").putImageData(picture.pixels, 0, 0);
    }
}

export class View {
    /** Emits when pan, zoom, tiling or the size of the canvas change. */
    moved = new Signal();

    #canvas;
    #context;
    #picture = new Layer();
    #before = new Layer();
    #version = 0;
    #fitted = true;
    #center = [0, 0];
    #zoom = 1;

    /**
     * The size of the images of the preset (`image.size`) or of the baked set, in pixels. The view does not change when
     * a picture of another width is shown.
     */
    size = [1024, 1024];
    /** The number of copies of the tile in each direction. */
    tiling = 1;
    /** The position of the dividing line as a fraction of the canvas's width; null shows no comparison. */
    split = null;

    constructor(canvas) {
        this.#canvas = canvas;
        this.#context = canvas.getContext("2d");
        this.gestures = new ViewGestures(canvas, this);
        new ResizeObserver(() => this.#resize()).observe(canvas);
        this.#resize();
    }

    /** The picture on the canvas, or null. */
    get picture() {
        return this.#picture.picture;
    }

    /** CSS pixels per pixel of `size`. */
    get zoom() {
        return this.#zoom;
    }

    /** True if the whole picture is shown and stays so when the window changes. */
    get fitted() {
        return this.#fitted;
    }

    /** Shows a picture, as a source returns it (source.js). */
    show(picture) {
        this.#picture.show(picture);
        this.draw();
        Object.assign(this.#canvas.dataset, {
            frame: picture.frame,
            exact: picture.exact,
            map: picture.map,
            width: picture.width,
            version: ++this.#version,
        });
    }

    /** Keeps a picture to compare with. */
    keepBefore(picture) {
        if (picture) {
            this.#before.show(picture);
        }
    }

    get hasBefore() {
        return this.#before.picture !== null;
    }

    setSize(size) {
        if (size[0] !== this.size[0] || size[1] !== this.size[1]) {
            this.size = size;
            this.fit();
        }
    }

    setTiling(tiling) {
        this.tiling = tiling;
        this.fit();
    }

    /** Shows all tiles. */
    fit() {
        this.#fitted = true;
        const {clientWidth, clientHeight} = this.#canvas;
        const [width, height] = this.size.map((side) => side * this.tiling);
        this.#zoom = Math.max(
            0.001,
            Math.min((clientWidth - 2 * kMargin) / width, (clientHeight - 2 * kMargin) / height),
        );
        this.#center = [width / 2, height / 2];
        this.#changed();
    }

    /** Multiplies the zoom. The point of the picture at `x`, `y` (CSS pixels of the canvas) stays where it is. */
    zoomBy(factor, x = this.#canvas.clientWidth / 2, y = this.#canvas.clientHeight / 2) {
        this.setZoom(this.#zoom * factor, x, y);
    }

    setZoom(zoom, x = this.#canvas.clientWidth / 2, y = this.#canvas.clientHeight / 2) {
        const [u, v] = this.#toTilePixels(x, y);
        this.#zoom = clamp(zoom, 0.02, kMaxZoom);
        this.#center[0] += u - this.#toTilePixels(x, y)[0];
        this.#center[1] += v - this.#toTilePixels(x, y)[1];
        this.#fitted = false;
        this.#changed();
    }

    /** Moves the picture by CSS pixels. */
    pan(dx, dy) {
        const limit = this.size.map((side) => side * this.tiling);
        this.#center[0] = clamp(this.#center[0] - dx / this.#zoom, 0, limit[0]);
        this.#center[1] = clamp(this.#center[1] - dy / this.#zoom, 0, limit[1]);
        this.#fitted = false;
        this.#changed();
    }

    /**
     * Returns the point of a tile that is at `x`, `y` (CSS pixels of the canvas), as fractions of the tile's width and
     * height from its upper left corner. Returns null if there is no tile.
     */
    pointAt(x, y) {
        const point = this.#toTilePixels(x, y).map((value, axis) => value / this.size[axis]);
        const inside = point.every((value) => value >= 0 && value < this.tiling);
        return inside ? point.map((value) => value % 1) : null;
    }

    /** Returns the position of a point of the first tile, given as fractions, in CSS pixels of the canvas. */
    positionOf(u, v) {
        return [
            (u * this.size[0] - this.#center[0]) * this.#zoom + this.#canvas.clientWidth / 2,
            (v * this.size[1] - this.#center[1]) * this.#zoom + this.#canvas.clientHeight / 2,
        ];
    }

    /** A width of pictures, in pixels, that suits the canvas. */
    get suitableWidth() {
        return Math.min(this.#canvas.width, this.#canvas.height) > kSmallCanvas ? 1024 : 512;
    }

    /** Device pixels per pixel of `size`. */
    get deviceZoom() {
        return this.#zoom * devicePixelRatio;
    }

    /** Draws the canvas again. */
    draw() {
        const context = this.#context;
        const {width, height} = this.#canvas;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, width, height);
        if (!this.picture) {
            return;
        }
        if (this.split === null || !this.hasBefore) {
            this.#drawLayer(this.#picture, 0, width);
            return;
        }
        const line = Math.round(this.split * width);
        this.#drawLayer(this.#before, 0, line);
        this.#drawLayer(this.#picture, line, width);
    }

    // Returns the point at `x`, `y` (CSS pixels of the canvas) in pixels of `size`, from the upper left corner of the
    // first tile.
    #toTilePixels(x, y) {
        return [
            this.#center[0] + (x - this.#canvas.clientWidth / 2) / this.#zoom,
            this.#center[1] + (y - this.#canvas.clientHeight / 2) / this.#zoom,
        ];
    }

    // The edges of tiles are on whole device pixels, so that no seams appear between tiles.
    #edges(axis) {
        const half = (axis === 0 ? this.#canvas.width : this.#canvas.height) / 2;
        return Array.from({length: this.tiling + 1}, (_, index) =>
            Math.round((index * this.size[axis] - this.#center[axis]) * this.deviceZoom + half),
        );
    }

    // Draws a layer between two columns of the canvas.
    #drawLayer(layer, left, right) {
        const context = this.#context;
        const [columns, rows] = [this.#edges(0), this.#edges(1)];
        context.save();
        context.beginPath();
        context.rect(left, 0, right - left, this.#canvas.height);
        context.clip();
        if (layer.picture.transparent) {
            this.#drawChecker(columns, rows);
        }
        context.imageSmoothingEnabled = (columns[1] - columns[0]) / layer.picture.width < kSmoothBelow;
        context.imageSmoothingQuality = "medium";
        for (let row = 0; row < this.tiling; ++row) {
            for (let column = 0; column < this.tiling; ++column) {
                context.drawImage(
                    layer.canvas,
                    columns[column],
                    rows[row],
                    columns[column + 1] - columns[column],
                    rows[row + 1] - rows[row],
                );
            }
        }
        context.restore();
    }

    #drawChecker(columns, rows) {
        const side = kChecker * devicePixelRatio;
        const pattern = document.createElement("canvas");
        pattern.width = pattern.height = 2 * side;
        const context = pattern.getContext("2d");
        context.fillStyle = "#8a8a8a";
        context.fillRect(0, 0, 2 * side, 2 * side);
        context.fillStyle = "#7c7c7c";
        context.fillRect(0, 0, side, side);
        context.fillRect(side, side, side, side);
        this.#context.fillStyle = this.#context.createPattern(pattern, "repeat");
        this.#context.fillRect(columns[0], rows[0], columns.at(-1) - columns[0], rows.at(-1) - rows[0]);
    }

    #resize() {
        const {clientWidth, clientHeight} = this.#canvas;
        if (clientWidth === 0 || clientHeight === 0) {
            return;
        }
        this.#canvas.width = Math.round(clientWidth * devicePixelRatio);
        this.#canvas.height = Math.round(clientHeight * devicePixelRatio);
        if (this.#fitted) {
            this.fit();
        } else {
            this.#changed();
        }
    }

    #changed() {
        this.draw();
        this.moved.emit();
    }
}
