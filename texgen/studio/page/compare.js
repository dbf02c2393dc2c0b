// SPDX-License-Identifier: Apache-2.0

// Compares the current picture with an earlier one: the picture before the last change, or a picture that the user has
// kept. The earlier picture is shown to the left of a dividing line, which the user can move.

import {$, clamp} from "./dom.js";

const kStep = 0.02; // how far a press of an arrow key moves the line, as a fraction of the width of the canvas

export class Compare {
    #studio;
    #split = 0.5;
    #kept = false;
    #gesture = null; // the keys that the last edit changed, if it was part of a gesture such as a drag
    #replaced = null; // the picture that was shown at the last edit
    #changes = 1; // how many edits the picture on the left is behind the current one

    constructor(studio) {
        this.#studio = studio;
        const {state, ui, view} = studio;
        const line = $("split");
        $("compare").addEventListener("click", () => this.toggle());
        $("compare-keep").addEventListener("click", () => this.keep());
        state.changed.on((change) => this.#onEdit(change));
        ui.on("compare", () => this.#show());
        line.addEventListener("pointerdown", (event) => line.setPointerCapture(event.pointerId));
        line.addEventListener("pointermove", (event) => this.#drag(event));
        line.addEventListener("keydown", (event) => this.#key(event));
        view.moved.on(() => this.#place());
        this.#show();
    }

    toggle() {
        this.#studio.ui.set("compare", !this.#studio.ui.get("compare"));
    }

    /** Keeps the current picture for comparison, until another is kept or a preset is opened. */
    keep() {
        const {picture} = this.#studio.view;
        if (!picture) {
            return;
        }
        this.#kept = true;
        this.#changes = 0;
        this.#studio.view.keepBefore(picture);
        this.#studio.ui.set("compare", true);
        this.#show();
        this.#studio.status.say("The picture is kept for comparison.");
    }

    // Remembers the picture before an edit, unless the user has kept a picture. The edits of one gesture, such as the
    // dragging of a control, count as one.
    #onEdit({opened, keys, live}) {
        const gesture = live ? keys.join() : null;
        if (opened) {
            this.#kept = false;
        }
        if (gesture === null ? this.#gesture === null : gesture !== this.#gesture) {
            this.#remember();
        }
        this.#gesture = gesture;
        this.#show();
    }

    // Keeps the shown picture as the picture before the present edit. If the shown picture is a draft, or has not
    // changed since the previous edit, it does not show the settings before the present edit. The earlier picture is
    // then kept, and is one more change behind.
    #remember() {
        const {view} = this.#studio;
        const {picture} = view;
        const isNew = picture !== null && picture !== this.#replaced && !picture.draft;
        this.#replaced = picture;
        if (!this.#kept && (isNew || !view.hasBefore)) {
            view.keepBefore(picture);
            this.#changes = 1;
        } else {
            this.#changes += 1;
        }
    }

    get #label() {
        if (this.#kept) {
            return "Kept picture";
        }
        return this.#changes === 1 ? "Before the last change" : `Before the last ${this.#changes} changes`;
    }

    #show() {
        const {ui, view} = this.#studio;
        const on = ui.get("compare");
        $("compare").setAttribute("aria-pressed", String(on));
        $("compare-bar").hidden = !on;
        $("compare-left").textContent = this.#label;
        $("split").hidden = !on;
        $("compare-none").hidden = view.hasBefore;
        this.#place();
    }

    #place() {
        const {ui, view} = this.#studio;
        view.split = ui.get("compare") ? this.#split : null;
        $("split").style.left = `${100 * this.#split}%`;
        $("split").setAttribute("aria-valuenow", String(Math.round(100 * this.#split)));
        view.draw();
    }

    #move(split) {
        this.#split = clamp(split, 0, 1);
        this.#place();
    }

    #drag(event) {
        if ($("split").hasPointerCapture(event.pointerId)) {
            const box = $("picture").getBoundingClientRect();
            this.#move((event.clientX - box.left) / box.width);
        }
    }

    #key(event) {
        const step = {ArrowLeft: -kStep, ArrowRight: kStep, Home: -1, End: 1}[event.key];
        if (step) {
            event.preventDefault();
            event.stopPropagation();
            this.#move(this.#split + step);
        }
    }
}
