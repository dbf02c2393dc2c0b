// SPDX-License-Identifier: Apache-2.0

// Keeps the frames of a loop in memory: loads them in order, and plays them.

import {ApiError} from "./api.js";
import {Signal} from "./signal.js";

const kRequests = 2; // frames that are requested at the same time
const kAhead = 0.5; // seconds of frames that must be loaded before the loop starts to play
const kMemory = 768 * 1024 * 1024; // bytes for the frames of a loop
const kAttempts = 3; // how often the loading is started, if the simulation is stopped each time
const kRetry = 1000; // milliseconds between two attempts

export class Player {
    /**
     * Emits the number of the frame that must be shown, and its picture, or null if the picture is
     * not loaded.
     */
    framed = new Signal();
    /** Emits when frames were loaded or dropped, when playing starts or stops, and after `configure` and `seek`. */
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
    #clock = null; // {start, frame}: `frame` was shown at the time `start`; null while the loop waits for frames

    /** Sets the number of frames and their rate. Keeps the current frame if it exists. */
    configure(count, framesPerSecond) {
        this.count = count;
        this.framesPerSecond = framesPerSecond;
        this.frame = Math.min(this.frame, count);
        this.changed.emit();
    }

    /** Forgets all frames and stops loading. */
    clear() {
        this.#abort?.abort();
        this.#abort = null;
        this.#frames = [];
        this.#loaded = 0;
        this.changed.emit();
    }

    /** Returns the picture of a frame, or undefined. */
    pictureOf(frame) {
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

    /**
     * Returns `width`, or a smaller width at which all frames of the loop fit into kMemory bytes. Widths of 64 pixels
     * or less are returned even if the frames do not fit.
     */
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
     * Loads all missing frames, in order from the current one. `request(frame, quality, signal)` returns a picture.
     * Pictures that were drawn before the automatic range of the map was known (`exact` is false) are loaded again at
     * the end, in the quality "exact": all frames are then simulated, and the range of a bake can be found. If the
     * simulation is stopped (status 409), the loading starts again after `kRetry` milliseconds, at most `attempts` - 1
     * times.
     */
    async load(request, attempts = kAttempts) {
        this.#abort?.abort();
        const abort = new AbortController();
        this.#abort = abort;
        let failure = null;
        try {
            await this.#loadWhere((picture) => !picture, "full", request, abort.signal);
            await this.#loadWhere((picture) => !picture?.exact, "exact", request, abort.signal);
        } catch (error) {
            abort.abort();
            failure = error instanceof ApiError ? error : null;
        }
        if (this.#abort !== abort) {
            return; // the frames were cleared, or are loaded by a later call
        }
        if (failure?.status === 409 && attempts > 1) {
            setTimeout(() => this.#abort === abort && this.load(request, attempts - 1), kRetry);
            return;
        }
        this.#abort = null;
        if (failure) {
            this.failed.emit(failure);
        }
        this.changed.emit();
    }

    async #loadWhere(isMissing, quality, request, signal) {
        const order = Array.from({length: this.count}, (_, index) => ((this.frame - 1 + index) % this.count) + 1);
        const queue = order.filter((frame) => isMissing(this.#frames[frame]));
        await Promise.all(Array.from({length: kRequests}, () => this.#work(queue, quality, request, signal)));
    }

    async #work(queue, quality, request, signal) {
        for (let frame = queue.shift(); frame !== undefined; frame = queue.shift()) {
            const picture = await request(frame, quality, signal);
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

    /** Restarts the clock of the loop at the current frame. Called when the speed has changed. */
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
        // The number of steps is rounded. If the loop plays at the refresh rate of the screen, this
        // number can be just below a whole number. If its fraction were cut off, some frames would
        // be shown twice and the frames after them skipped.
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
