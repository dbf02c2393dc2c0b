// SPDX-License-Identifier: Apache-2.0

// The bar at the bottom: what the program is doing, and short messages.

import {ApiError, connectionState, page, post} from "./api.js";
import {$} from "./dom.js";

const kPoll = 300; // milliseconds between two requests for the progress of the simulation
const kMessageTime = 6000; // milliseconds for which a message stays

export class StatusBar {
    #studio;
    #busy = false;
    #timer = 0;
    #hide = 0;

    constructor(studio) {
        this.#studio = studio;
        const {folder, threads, version} = studio.program;
        $("status-folder").textContent = folder;
        $("status-version").textContent = `foamtex ${version} · ${threads} ${threads === 1 ? "thread" : "threads"}`;
        studio.painter.status.on((status) => this.#onPainter(status));
        studio.player.changed.on(() => this.#watch());
        studio.player.failed.on((error) => this.#showError(error));
    }

    /** Shows a message for some seconds. Screen readers read it. */
    say(text) {
        $("message").textContent = text;
        clearTimeout(this.#hide);
        this.#hide = setTimeout(() => {
            $("message").textContent = "";
        }, kMessageTime);
    }

    #onPainter({busy, message, error}) {
        this.#busy = busy;
        document.body.classList.toggle("busy", busy);
        this.#showError(message === null ? null : error);
        this.#watch();
    }

    // Shows an error over the picture. The message of an error about a key is shown beside the
    // field of the key; over the picture, another text says only which settings are shown.
    #showError(error) {
        $("stage-message").hidden = !error;
        $("stage-message").textContent = error?.key
            ? "The picture shows the last settings that are allowed."
            : (error?.message ?? "");
    }

    get #active() {
        return (this.#busy || this.#studio.player.loading) && !this.#studio.baked && connectionState() === "online";
    }

    #watch() {
        if (this.#active && this.#timer === 0) {
            this.#timer = setTimeout(() => this.#poll(), kPoll);
        } else if (!this.#active) {
            this.#show("");
        }
    }

    async #poll() {
        if (this.#active) {
            try {
                this.#showProgress(await post("/api/simulation", {settings: this.#studio.state.settings(), page}));
            } catch (error) {
                if (error instanceof ApiError && ![409, 422].includes(error.status)) {
                    this.#show(error.message);
                }
            }
        }
        this.#timer = 0;
        this.#watch();
    }

    #showProgress({status, phase, done, total, cycle}) {
        if (!this.#active || status !== "running") {
            this.#show(status === "running" || this.#studio.player.complete ? "" : "Drawing the loop");
            return;
        }
        const step = cycle ? `, cycle ${cycle}` : total > 0 ? `, frame ${done} of ${total}` : "";
        this.#show(`Simulating: ${phase || "foam"}${step}`);
    }

    #show(text) {
        $("activity").textContent = text;
    }
}
