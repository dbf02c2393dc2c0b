// SPDX-License-Identifier: Apache-2.0

// Lets the user turn, light and magnify the lit preview with the pointer, the wheel and the keyboard.

import {wheelPixels} from "./dom.js";

const kTurnPerHeight = Math.PI;  // radians by which a drag along the height of the canvas turns the shape
const kTurnPerKey = Math.PI / 36;
const kLightPerKey = 0.06;
const kZoomPerKey = 1.15;
const kArrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

// Makes the canvas focusable. Calls the functions of `actions` when the user works
// with the canvas:
//   orbit(turn, tilt)   turns the shape, in radians
//   light(x, y)         moves the light, in half-heights of the canvas, x to the right and y up
//   zoom(factor, at)    magnifies about the point `at`, x in half-widths and y in half-heights of the canvas from the
//                       center of the canvas; without `at`, about the center
//   reset()             shows the default view
// Returns a function that removes the listeners.
export function attachControls(canvas, actions) {
    const stop = new AbortController();
    const listen = (type, listener, options = {}) =>
        canvas.addEventListener(type, listener, {...options, signal: stop.signal});
    canvas.style.touchAction = "none";
    canvas.tabIndex = Math.max(canvas.tabIndex, 0);
    const pointers = new Map();
    let movesLight = false;

    const positionOf = (event) => {
        const box = canvas.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2];
    };
    const spreadOf = () => {
        const [first, second] = [...pointers.values()];
        return Math.hypot(first.x - second.x, first.y - second.y);
    };

    listen("pointerdown", (event) => {
        if (event.button === 1) {
            return;
        }
        movesLight = event.shiftKey || event.button === 2;
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        canvas.setPointerCapture(event.pointerId);
    });
    listen("pointermove", (event) => {
        const last = pointers.get(event.pointerId);
        if (!last) {
            return;
        }
        const height = canvas.clientHeight || 1;
        const x = (event.clientX - last.x) / height;
        const y = (event.clientY - last.y) / height;
        const spread = pointers.size === 2 ? spreadOf() : 0;
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        if (pointers.size === 2) {
            actions.zoom(spreadOf() / Math.max(spread, 1), positionOf(event));
        } else if (movesLight) {
            actions.light(2 * x, -2 * y);
        } else {
            actions.orbit(x * kTurnPerHeight, y * kTurnPerHeight);
        }
    });
    for (const type of ["pointerup", "pointercancel", "lostpointercapture"]) {
        listen(type, (event) => pointers.delete(event.pointerId));
    }
    listen("contextmenu", (event) => event.preventDefault());
    listen("dblclick", () => actions.reset());
    listen("wheel", (event) => {
        event.preventDefault();
        actions.zoom(Math.exp(-Math.min(Math.max(wheelPixels(event), -300), 300) * 0.0015), positionOf(event));
    }, {passive: false});
    listen("keydown", (event) => {
        if (actOnKey(event, actions)) {
            event.preventDefault();
        }
    });
    return () => stop.abort();
}

// Calls the action of the key. Returns false if the key has none.
function actOnKey(event, actions) {
    if (event.ctrlKey || event.altKey || event.metaKey) {
        return false;
    }
    const arrow = kArrows[event.key];
    if (arrow && event.shiftKey) {
        actions.light(arrow[0] * kLightPerKey, -arrow[1] * kLightPerKey);
    } else if (arrow) {
        actions.orbit(arrow[0] * kTurnPerKey, arrow[1] * kTurnPerKey);
    } else if (event.key === "+" || event.key === "=") {
        actions.zoom(kZoomPerKey);
    } else if (event.key === "-") {
        actions.zoom(1 / kZoomPerKey);
    } else if (event.key === "Home" || event.key === "0") {
        actions.reset();
    } else {
        return false;
    }
    return true;
}
