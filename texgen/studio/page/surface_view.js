// SPDX-License-Identifier: Apache-2.0

import {kShapes} from "./surface_mesh.js";

// The camera of the lit preview (surface.js), and the rotation of the shape, a plane, a sphere or a
// cylinder, in front of the camera. The camera is on a circle around the x axis; `tilt` is its
// angle above the z axis. `turn` rotates the shape about its own axis. The light and the sky stay
// where they are, so that the lit side always faces the viewer. `zoom` magnifies the image; `pan`
// is the position of the middle of the magnified image on the canvas, in half-widths and
// half-heights of the canvas from the center of the canvas.
const kFieldOfView = 28 / 180 * Math.PI;
const kMaxZoom = 24;
const kMinZoom = 0.5;

export class View {
    constructor(shape) {
        this.setShape(shape);
    }

    setShape(shape) {
        this.shape = kShapes[shape];
        this.reset();
    }

    reset() {
        this.tilt = this.shape.tilt;
        this.turn = 0;
        this.zoom = 1;
        this.pan = [0, 0];
    }

    // Turns the shape and tilts the camera, by angles in radians.
    orbit(turn, tilt) {
        const [least, most] = this.shape.tilts;
        this.turn = (this.turn + turn) % (2 * Math.PI);
        this.tilt = Math.min(Math.max(this.tilt + tilt, least), most);
    }

    // Magnifies the image by `factor`. The point of the image that is at the position `at` of the canvas (in the units
    // of `pan`) stays there, unless the limits of `pan` prevent this.
    zoomBy(factor, at = [0, 0]) {
        const zoom = Math.min(Math.max(this.zoom * factor, kMinZoom), kMaxZoom);
        const applied = zoom / this.zoom;
        const limit = Math.max(zoom - 1, 0);
        this.zoom = zoom;
        this.pan = this.pan.map((pan, k) => Math.min(Math.max(at[k] + (pan - at[k]) * applied, -limit), limit));
    }

    // Returns the rotation of the shape as a matrix of 3 columns.
    turnMatrix() {
        const c = Math.cos(this.turn);
        const s = Math.sin(this.turn);
        return this.shape.turnsAbout === "z" ? [c, s, 0, -s, c, 0, 0, 0, 1] : [c, 0, -s, 0, 1, 0, s, 0, c];
    }

    distance(aspect) {
        const half = Math.tan(kFieldOfView / 2) * Math.min(aspect, 1);
        return this.shape.radius / Math.sin(Math.atan(half));
    }

    cameraPosition(aspect) {
        const distance = this.distance(aspect);
        return [0, distance * Math.sin(this.tilt), distance * Math.cos(this.tilt)];
    }

    // Returns the product of the projection and the view as a matrix of 4 columns. `aspect` is width / height.
    projection(aspect) {
        const distance = this.distance(aspect);
        const near = Math.max(distance - 2.5, 0.1);
        const far = distance + 2.5;
        const y = this.zoom / Math.tan(kFieldOfView / 2);
        const x = y / aspect;
        const c = Math.cos(this.tilt);
        const s = Math.sin(this.tilt);
        // The depth in front of the camera is w = distance - s y - c z. The axis of the view that
        // points up is (0, c, -s).
        const a = (far + near) / (far - near);
        const b = -2 * far * near / (far - near);
        const panX = this.pan[0];
        const panY = this.pan[1] - this.shape.lift * s * this.zoom;
        return [
            x, 0, 0, 0,
            -s * panX, y * c - s * panY, -a * s, -s,
            -c * panX, -y * s - c * panY, -a * c, -c,
            distance * panX, distance * panY, a * distance + b, distance,
        ];
    }
}
