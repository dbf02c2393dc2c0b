// SPDX-License-Identifier: Apache-2.0

// The frames of a loop in memory: loads them in order, and plays them.

import {ApiError} from "./api.js";
import {Signal} from "./signal.js";

const kRequests = 2; // frames that are requested at the same time
const kAhead = 0.5; // seconds of frames that must exist before the loop starts to play
const kMemory = 768 * 1024 * 1024; // bytes for the frames of a loop

export class Player {
    /** Emits the number of the frame that must be shown, and its picture or null if it is not loaded. */
    framed = new Signal();
    /** Emits when frames were loaded or dropped, or when playing starts or stops. */
    changed = new Signal();
    /** Emits an ApiError that stopped the loading. */
    failed = new Signal();

    count = 1;
    framesPerSecond = 24;
    speed = 1;
    frame = 1;
    playing = false;

    #frames = [];
    #loaded = 0;
    #abort = null;
    #clock = null;

    /** Sets the number of frames and their rate. Keeps the current frame if it exists. */
    configure(count, framesPerSecond) {
        this.count = count;
        this.framesPerSecond = framesPerSecond;
        this.frame = Math.min(this.frame, count);
        this.changed.emit();
    }

    /** Forgets all frames and stops to load. */
    clear() {
        this.#abort?.abort();
        this.#abort = null;
        this.#frames = [];
        this.#loaded = 0;
        this.changed.emit();
    }

    /** Returns the picture of a frame, or undefined. */
    at(frame) {
        return this.#frames[frame];
    }

    /** The number of loaded frames. */
    get loaded() {
        return this.#loaded;
    }

    get complete() {
        return this.#loaded >= this.count;
    }

    /** True while frames are being loaded. */
    get loading() {
        return this.#abort !== null;
    }

    /** Returns the width of frames of a loop: `width`, or less so that all frames fit into memory. */
    loopWidth(width, aspect) {
        let narrow = width;
        while (narrow > 64 && 4 * narrow * narrow * aspect * this.count > kMemory) {
            narrow = Math.round(narrow / 2);
        }
        return narrow;
    }

    put(frame, picture) {
        const old = this.#frames[frame];
        this.#loaded += old ? 0 : 1;
        this.#frames[frame] = picture;
        if (old && frame === this.frame && !this.playing) {
            this.framed.emit(frame, picture);
        }
        this.changed.emit();
    }

    /**
     * Loads all missing frames, first those after the current one. `request(frame, signal)` returns a picture. Frames
     * whose automatic range was not known yet are loaded again at the end.
     */
    async load(request) {
        this.#abort?.abort();
        const abort = new AbortController();
        this.#abort = abort;
        try {
            await this.#loadWhere((picture) => !picture, request, abort.signal);
            await this.#loadWhere((picture) => !picture?.exact, request, abort.signal);
        } catch (error) {
            abort.abort();
            if (error instanceof ApiError && error.status !== 409) {
                this.failed.emit(error);
            }
        }
        if (this.#abort === abort) {
            this.#abort = null;
            this.changed.emit();
        }
    }

    async #loadWhere(isMissing, request, signal) {
        const order = Array.from({length: this.count}, (_, index) => ((this.frame - 1 + index) % this.count) + 1);
        const queue = order.filter((frame) => isMissing(this.#frames[frame]));
        await Promise.all(Array.from({length: kRequests}, () => this.#work(queue, request, signal)));
    }

    async #work(queue, request, signal) {
        for (let frame = queue.shift(); frame !== undefined; frame = queue.shift()) {
            const picture = await request(frame, signal);
            if (signal.aborted) {
                return;
            }
            this.put(frame, picture);
        }
    }

    play() {
        if (!this.playing && this.count > 1) {
            this.playing = true;
            this.#clock = null;
            requestAnimationFrame((time) => this.#tick(time));
            this.changed.emit();
        }
    }

    pause() {
        if (this.playing) {
            this.playing = false;
            this.changed.emit();
        }
    }

    toggle() {
        this.playing ? this.pause() : this.play();
    }

    /** Shows a frame; numbers beyond the ends continue at the other end. */
    seek(frame) {
        this.frame = ((((Math.round(frame) - 1) % this.count) + this.count) % this.count) + 1;
        this.#clock = null;
        this.framed.emit(this.frame, this.#frames[this.frame] ?? null);
        this.changed.emit();
    }

    /** Starts to count time anew, because the speed has changed. */
    restart() {
        this.#clock = null;
    }

    step(frames) {
        this.pause();
        this.seek(this.frame + frames);
    }

    // Returns true if the next frames are loaded, so that playing does not stop at once.
    #ready() {
        const needed = Math.min(this.count, Math.ceil(kAhead * this.framesPerSecond * this.speed));
        for (let step = 0; step < needed; ++step) {
            if (!this.#frames[((this.frame - 1 + step) % this.count) + 1]) {
                return false;
            }
        }
        return true;
    }

    #tick(time) {
        if (!this.playing) {
            return;
        }
        requestAnimationFrame((next) => this.#tick(next));
        if (this.#clock === null) {
            this.#clock = this.complete || this.#ready() ? {start: time, frame: this.frame} : null;
            return;
        }
        // Rounded, because at the rate of the screen a fraction just below a whole number would skip frames.
        const steps = Math.round(((time - this.#clock.start) * this.framesPerSecond * this.speed) / 1000);
        const frame = ((this.#clock.frame - 1 + steps) % this.count) + 1;
        if (frame === this.frame) {
            return;
        }
        if (!this.#frames[frame]) {
            this.#clock = null;
            return;
        }
        this.frame = frame;
        this.framed.emit(frame, this.#frames[frame]);
    }
}
