// SPDX-License-Identifier: Apache-2.0

/**
 * Runs one request at a time. While a request is running, only the newest of the requests that follow is kept. A newer
 * request cancels one that has been running for longer than `patience` milliseconds, for example because it waits for a
 * simulation that nobody wants any more.
 */
export class Lane {
    #patience;
    #running = null;
    #waiting = null;

    constructor(patience) {
        this.#patience = patience;
    }

    /** True while a request is running. */
    get busy() {
        return this.#running !== null;
    }

    /** Runs `request`, a function from an AbortSignal to a promise, now or as soon as possible. */
    run(request) {
        this.#waiting = request;
        if (this.#running) {
            this.#cancelWhenOverdue(this.#running);
        } else {
            this.#next();
        }
    }

    /** Cancels the running request and forgets the waiting one. */
    stop() {
        this.#waiting = null;
        this.#running?.abort.abort();
    }

    // Cancels the running request when it has been running for `patience` milliseconds, or now if it already has. Does
    // nothing if no other request waits at that time.
    #cancelWhenOverdue(running) {
        const left = running.start + this.#patience - performance.now();
        const cancel = () => {
            if (this.#waiting) {
                running.abort.abort();
            }
        };
        running.timer ??= setTimeout(cancel, Math.max(0, left));
    }

    async #next() {
        const request = this.#waiting;
        this.#waiting = null;
        const running = {abort: new AbortController(), start: performance.now(), timer: null};
        this.#running = running;
        try {
            await request(running.abort.signal);
        } catch (error) {
            if (error.name !== "AbortError") {
                console.error(error);
            }
        }
        clearTimeout(running.timer);
        this.#running = null;
        if (this.#waiting) {
            this.#next();
        }
    }
}
