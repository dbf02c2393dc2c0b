// SPDX-License-Identifier: Apache-2.0

// The controls below the picture: buttons that play, pause and step, a slider that selects the frame, the choice of the
// speed, and a bar that shows which frames are loaded.

import {$, setIcon, setLabel} from "./dom.js";

const kUpdate = 100; // milliseconds between two updates while frames are being loaded
const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];

export class Transport {
    #player;
    #ui;
    #scheduled = false;

    constructor({player, ui}) {
        this.#player = player;
        this.#ui = ui;
        $("play").addEventListener("click", () => player.toggle());
        $("first").addEventListener("click", () => this.#jump(1));
        $("last").addEventListener("click", () => this.#jump(player.count));
        $("previous").addEventListener("click", () => player.step(-1));
        $("next").addEventListener("click", () => player.step(1));
        $("scrub").addEventListener("input", () => this.#jump(Number($("scrub").value)));
        $("speed").addEventListener("change", () => this.setSpeed(Number($("speed").value)));
        player.framed.on(() => this.#showFrame());
        player.changed.on(() => this.#schedule());
        new ResizeObserver(() => this.#showBuffer()).observe($("buffer"));
        new MutationObserver(() => this.#showBuffer()).observe(document.documentElement, {
            attributeFilter: ["data-theme"],
        });
        this.setSpeed(ui.get("speed"));
        this.#show();
    }

    /** Plays `speed` times as fast as the preset says. */
    setSpeed(speed) {
        this.#player.speed = speed;
        this.#ui.set("speed", speed);
        $("speed").value = String(speed);
        this.#player.restart();
    }

    /** Selects the next speed of kSpeeds if `step` is 1, the previous speed if it is -1. */
    stepSpeed(step) {
        const index = kSpeeds.indexOf(this.#player.speed) + step;
        this.setSpeed(kSpeeds[Math.min(Math.max(index, 0), kSpeeds.length - 1)]);
    }

    #jump(frame) {
        this.#player.pause();
        this.#player.seek(frame);
    }

    // Shows the state of the player soon. Many frames are loaded within a second, and drawing the
    // bar takes milliseconds, so several changes share one update.
    #schedule() {
        if (!this.#scheduled) {
            this.#scheduled = true;
            const show = () => {
                this.#scheduled = false;
                this.#show();
            };
            this.#player.loading ? setTimeout(show, kUpdate) : requestAnimationFrame(show);
        }
    }

    #show() {
        const player = this.#player;
        const still = player.count < 2;
        setIcon($("play"), player.playing ? "pause" : "play");
        setLabel($("play"), player.playing ? "Pause (Space)" : "Play (Space)");
        for (const id of ["play", "first", "last", "previous", "next", "scrub", "speed"]) {
            $(id).disabled = still;
        }
        $("scrub").max = player.count;
        $("frame-count").textContent = `/ ${player.count}`;
        $("loaded").textContent = still
            ? ""
            : player.complete
              ? "Loop in memory"
              : `${player.loaded} of ${player.count} loaded`;
        document.body.dataset.loaded = `${player.loaded}/${player.count}`;
        this.#showFrame();
        this.#showBuffer();
    }

    #showFrame() {
        const {frame, framesPerSecond} = this.#player;
        $("scrub").value = frame;
        $("scrub").setAttribute("aria-valuetext", `Frame ${frame}`);
        $("frame").textContent = frame;
        $("time").textContent = `${((frame - 1) / framesPerSecond).toFixed(2)} s`;
    }

    #showBuffer() {
        const canvas = $("buffer");
        const width = Math.round(canvas.clientWidth * devicePixelRatio);
        if (width === 0) {
            return;
        }
        canvas.width = width;
        canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
        const context = canvas.getContext("2d");
        context.fillStyle = getComputedStyle(canvas).color;
        const {count} = this.#player;
        for (let frame = 1; frame <= count; ++frame) {
            if (this.#player.pictureOf(frame)) {
                const left = Math.round(((frame - 1) / count) * width);
                context.fillRect(left, 0, Math.round((frame / count) * width) - left, canvas.height);
            }
        }
    }
}
