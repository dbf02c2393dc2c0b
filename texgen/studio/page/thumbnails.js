// SPDX-License-Identifier: Apache-2.0

import {ApiError, ConnectionError, connectionState, postPicture} from "./api.js";

const kWidth = 160; // pixels
const kPause = 30; // milliseconds between two pictures
const kPauseLoading = 250; // milliseconds between two pictures while the loop is being loaded
const kWait = 250; // milliseconds until the next attempt, while thumbnails have to wait
const kRest = 1000; // for this many milliseconds after an edit, no thumbnails are drawn

/**
 * Draws the thumbnails of the gallery one after the other when they are in sight. Thumbnails wait
 * while a full picture for the studio's view is awaited, while the server cannot be reached, and
 * for a second after an edit.
 */
export class Thumbnails {
    #studio;
    #waiting = [];
    #visible = new Set();
    #observer;
    #running = false;
    #edited = 0;

    constructor(studio, scroller) {
        this.#studio = studio;
        this.#observer = new IntersectionObserver((entries) => this.#onSight(entries), {
            root: scroller,
            rootMargin: "200px",
        });
        studio.state.changed.on(() => {
            this.#edited = performance.now();
        });
    }

    /** Adds a card whose canvas shows the preset. */
    add(card, canvas, preset) {
        this.#waiting.push({card, canvas, preset});
        this.#observer.observe(card);
    }

    /** Starts to draw. */
    start() {
        if (!this.#running && this.#waiting.length > 0) {
            this.#running = true;
            this.#next();
        }
    }

    #onSight(entries) {
        for (const {target, isIntersecting} of entries) {
            isIntersecting ? this.#visible.add(target) : this.#visible.delete(target);
        }
        if (this.#studio.painter.showsFrame) {
            this.start();
        }
    }

    get #busy() {
        return (
            document.body.classList.contains("busy") ||
            connectionState() !== "online" ||
            performance.now() - this.#edited < kRest
        );
    }

    async #next() {
        const entry = this.#waiting.find(({card}) => this.#visible.has(card));
        if (!entry) {
            this.#running = false;
            return;
        }
        if (this.#busy) {
            setTimeout(() => this.#next(), kWait);
            return;
        }
        await this.#draw(entry);
        setTimeout(() => this.#next(), this.#studio.player.loading ? kPauseLoading : kPause);
    }

    async #draw(entry) {
        const {canvas, preset} = entry;
        const body = {
            settings: {preset: preset.name, set: [], events: null},
            frame: 1,
            map: preset.maps[0],
            width: kWidth,
            quality: "draft",
            samples: "rgba",
        };
        try {
            const picture = await postPicture("/api/picture", body);
            canvas.width = picture.width;
            canvas.height = picture.height;
            canvas.getContext("2d").putImageData(picture.pixels, 0, 0);
            canvas.classList.add("drawn");
        } catch (error) {
            if (error instanceof ConnectionError) {
                return; // the thumbnail waits until the server can be reached again
            }
            if (!(error instanceof ApiError)) {
                console.error(error);
            }
        }
        this.#waiting = this.#waiting.filter((other) => other !== entry);
        this.#observer.unobserve(entry.card);
    }
}
