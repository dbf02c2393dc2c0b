// SPDX-License-Identifier: Apache-2.0

// The tab that shows the material on a lit surface.

import {$, debounce} from "./dom.js";
import {ApiError, postPicture} from "./api.js";

const kRest = 200; // milliseconds without an edit after which the maps are requested
const kWidth = 512; // largest width of the maps, in pixels

export class Lit {
    #studio;
    #surface = null;
    #abort = null;
    #stale = true;
    #later = debounce(kRest, () => this.#update());

    constructor(studio) {
        this.#studio = studio;
        studio.refreshed.on(() => this.#onChange());
        studio.answered.on(() => this.#onChange());
        studio.player.framed.on(() => !studio.player.playing && this.#onChange());
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

    #onChange() {
        this.#stale = true;
        if (this.#open) {
            this.#later();
        }
    }

    async #onMode() {
        if (this.#open && (await this.#create()) && this.#stale) {
            this.#update();
        }
    }

    // The module and its WebGL context are created when the tab is opened for the first time.
    async #create() {
        try {
            const {Surface} = await import("./surface.js");
            this.#surface ??= new Surface($("surface"));
            this.#showBackground();
            return true;
        } catch (error) {
            this.#fail(`The lit surface cannot be shown: ${error.message}`);
            return false;
        }
    }

    #fail(message) {
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
        try {
            const images = await this.#images(abort.signal);
            this.#surface.setImages(images);
            this.#apply();
            this.#fail(null);
            $("surface").dataset.version = Number($("surface").dataset.version ?? 0) + 1;
        } catch (error) {
            if (error instanceof ApiError && error.status !== 409) {
                this.#fail(error.message);
            }
        }
    }

    async #images(signal) {
        const {answer, state, player, painter} = this.#studio;
        const width = Math.min(kWidth, painter.width);
        const ask = (map, samples) =>
            postPicture(
                "/api/picture",
                {settings: state.settings(), frame: player.frame, map, width, quality: "full", samples},
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
