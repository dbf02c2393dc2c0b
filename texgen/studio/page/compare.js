// SPDX-License-Identifier: Apache-2.0

// Compares the picture with the one before the last change: a dividing line over the picture can be moved.

import {$, clamp} from "./dom.js";

const kStep = 0.02; // fraction of the width for a press of an arrow key

export class Compare {
    #studio;
    #split = 0.5;
    #kept = false;

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

    /** Keeps the picture that is shown as the one to compare with, until another one is kept. */
    keep() {
        this.#kept = true;
        this.#remember();
        this.#studio.ui.set("compare", true);
        this.#show();
        this.#studio.status.say("The picture is kept for comparison.");
    }

    // The first edit of a gesture keeps the picture before the edit.
    #onEdit({opened, keys, live}) {
        const gesture = live ? keys.join() : null;
        if (opened) {
            this.#kept = false;
        }
        if (!this.#kept && (gesture === null ? this.#gesture === null : gesture !== this.#gesture)) {
            this.#remember();
        }
        this.#gesture = gesture;
        this.#show();
    }

    #gesture = null;

    #remember() {
        const {picture} = this.#studio.view;
        if (picture?.exact || !this.#studio.view.hasBefore) {
            this.#studio.view.keepBefore(picture);
        }
    }

    #show() {
        const {ui, view} = this.#studio;
        const on = ui.get("compare");
        $("compare").setAttribute("aria-pressed", String(on));
        $("compare-bar").hidden = !on;
        $("compare-left").textContent = this.#kept ? "Kept picture" : "Before the last change";
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
