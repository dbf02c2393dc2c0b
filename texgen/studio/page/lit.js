// SPDX-License-Identifier: Apache-2.0

// The tab that shows the material on a lit surface. While the loop plays, the surface shows the
// frame that the player (player.js) has reached, as soon as the maps of this frame are loaded. While
// it plays, the maps of all frames are loaded, one frame after another, and kept until the next edit.

import {$, debounce} from "./dom.js";
import {ApiError, postPicture} from "./api.js";

const kRest = 200; // milliseconds without an edit after which the maps are requested
const kWidth = 512; // largest width of the maps, in pixels
const kBytesPerPixel = 28; // bytes per pixel of the seven maps of a frame (#images) together
const kRetry = 1000; // milliseconds from an error until frames may be loaded again
const kMemory = 384 * 1024 * 1024; // bytes for the maps of all frames of a loop

export class Lit {
    #studio;
    #surface = null;
    #abort = null;
    #stale = true; // true if the maps of the current frame must be requested
    #frames = new Map(); // the maps of each frame that was loaded while the loop played
    #loading = false; // true while the frames of the loop are being loaded
    #updating = false; // true while #update loads the maps of one frame at the full width, kWidth
    #retryAt = 0; // the time, in milliseconds, from which frames may be loaded again after an error
    #wasPlaying = false;
    #updateSoon = debounce(kRest, () => this.#update());

    constructor(studio) {
        this.#studio = studio;
        studio.refreshed.on(() => this.#onEdit());
        studio.answered.on(() => this.#onEdit());
        studio.player.framed.on((frame) => (studio.player.playing ? this.#onTick(frame) : this.#onChange()));
        studio.player.changed.on(() => this.#onPlayerChange());
        studio.ui.on("mode", () => this.#onMode());
        for (const id of ["lit-shape", "lit-tiling", "lit-azimuth", "lit-elevation", "lit-ambient", "lit-relief"]) {
            $(id).addEventListener("input", () => this.#apply());
        }
        $("surface").addEventListener("lightchange", (event) => this.#showLight(event.detail));
        new MutationObserver(() => this.#showBackground()).observe(document.documentElement, {
            attributeFilter: ["data-theme"],
        });
        fillSliders();
        this.#onMode();
    }

    get #open() {
        return this.#studio.ui.get("mode") === "lit";
    }

    #onEdit() {
        this.#frames.clear();
        this.#abort?.abort(); // a request that still runs asks for maps of the previous settings
        this.#onChange();
    }

    // When the loop is paused, requests the maps of the current frame at the full width.
    #onPlayerChange() {
        const {playing} = this.#studio.player;
        if (this.#wasPlaying && !playing) {
            this.#onChange();
        }
        this.#wasPlaying = playing;
    }

    #onTick(frame) {
        if (!this.#open || !this.#surface) {
            return;
        }
        const images = this.#frames.get(frame);
        if (images) {
            this.#show(images);
        }
        if (!this.#loading && !this.#updating && performance.now() >= this.#retryAt) {
            this.#loadFrames();
        }
    }

    // Loads the maps of all frames, first those after the current one, until the loop is paused or
    // everything is loaded.
    async #loadFrames() {
        const {player} = this.#studio;
        const frames = this.#frames;
        const mayGoOn = () => player.playing && this.#open && !this.#studio.baked && this.#studio.answer;
        this.#loading = true;
        try {
            while (mayGoOn() && frames.size < player.count) {
                const order = Array.from({length: player.count}, (_, k) => ((player.frame + k) % player.count) + 1);
                const frame = order.find((number) => !frames.has(number));
                this.#abort?.abort();
                const abort = new AbortController();
                this.#abort = abort;
                const images = await this.#images(abort.signal, frame, this.#loopWidth());
                if (abort.signal.aborted) {
                    return;
                }
                frames.set(frame, images);
            }
        } catch (error) {
            if (error.name !== "AbortError") {
                this.#retryAt = performance.now() + kRetry;
            }
            this.#report(error);
        } finally {
            this.#loading = false;
        }
    }

    // Returns the width of the maps of a loop: kWidth or, if square maps of all frames would then
    // need more than kMemory bytes, a smaller width, but not below 64.
    #loopWidth() {
        let width = kWidth;
        while (width > 64 && kBytesPerPixel * width * width * this.#studio.player.count > kMemory) {
            width /= 2;
        }
        return width;
    }

    #show(images) {
        this.#surface.setImages(images);
        this.#showMessage(null);
        $("surface").dataset.version = Number($("surface").dataset.version ?? 0) + 1;
    }

    #report(error) {
        if (error instanceof ApiError && error.status !== 409) {
            this.#showMessage(error.message);
        }
    }

    #onChange() {
        this.#stale = true;
        if (this.#open) {
            this.#updateSoon();
        }
    }

    async #onMode() {
        if (this.#open && (await this.#create()) && this.#stale) {
            this.#update();
        }
    }

    // Loads the module surface.js and creates its WebGL context when the tab is opened for the
    // first time. Returns false if this fails.
    async #create() {
        try {
            const {Surface} = await import("./surface.js");
            if (!this.#surface) {
                this.#surface = new Surface($("surface"));
                this.#apply();
            }
            this.#showBackground();
            return true;
        } catch (error) {
            this.#showMessage(`The lit surface cannot be shown: ${error.message}`);
            return false;
        }
    }

    #showMessage(message) {
        $("lit-message").hidden = message === null;
        $("lit-message").textContent = message ?? "";
    }

    async #update() {
        if (!this.#surface || !this.#open || this.#studio.baked || !this.#studio.answer) {
            return;
        }
        this.#abort?.abort();
        const abort = new AbortController();
        this.#abort = abort;
        this.#stale = false;
        this.#updating = true;
        try {
            this.#show(await this.#images(abort.signal, this.#studio.player.frame, kWidth));
            this.#apply();
        } catch (error) {
            this.#stale ||= !abort.signal.aborted; // requests the maps again when the surface is opened again
            // Status 409: the simulation was stopped, so the maps are requested again after a moment.
            if (error instanceof ApiError && error.status === 409 && !abort.signal.aborted) {
                this.#onChange();
            }
            this.#report(error);
        } finally {
            if (this.#abort === abort) { // no later update has begun
                this.#updating = false;
            }
        }
    }

    // Requests the maps of a frame. `widest` is their largest width in pixels.
    async #images(signal, frame, widest) {
        const {answer, state, painter} = this.#studio;
        const width = Math.min(widest, painter.width);
        const ask = (map, samples) =>
            postPicture(
                "/api/picture",
                {settings: state.settings(), frame, map, width, quality: "full", samples},
                signal,
            );
        const maps = {
            baseColor: answer.base_color,
            normal: "normal_gl",
            roughness: "roughness",
            occlusion: "occlusion",
            metallic: "metallic",
            emission: "emission",
        };
        const images = {};
        for (const [name, map] of Object.entries(maps)) {
            images[name] = (await ask(map, "rgba")).pixels;
        }
        const height = await ask("height", "float");
        images.height = {data: height.numbers, width: height.width, height: height.height, unit: height.unit_width};
        return images;
    }

    #apply() {
        const number = (id) => Number($(id).value);
        fillSliders();
        if (!this.#surface) {
            return;
        }
        this.#surface.setShape($("lit-shape").value);
        this.#surface.setTiling(number("lit-tiling"));
        this.#surface.setLight({azimuth: number("lit-azimuth"), elevation: number("lit-elevation")});
        this.#surface.setAmbient(number("lit-ambient"));
        this.#surface.setRelief(number("lit-relief"));
        this.#surface.render();
    }

    #showLight({azimuth, elevation}) {
        $("lit-azimuth").value = (azimuth + 360) % 360;
        $("lit-elevation").value = elevation;
        fillSliders();
    }

    #showBackground() {
        this.#surface?.setBackground(getComputedStyle($("panel-lit")).backgroundColor);
    }
}

function fillSliders() {
    for (const slider of $("lit-tools").querySelectorAll("input")) {
        slider.style.setProperty("--fill", `${(100 * (slider.value - slider.min)) / (slider.max - slider.min)}%`);
    }
}
