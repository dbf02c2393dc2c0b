// SPDX-License-Identifier: Apache-2.0

/** A list of functions that are called when something happens. */
export class Signal {
    #listeners = [];

    /** Adds a function. */
    on(listener) {
        this.#listeners.push(listener);
    }

    /** Calls all functions in the order in which they were added. */
    emit(...values) {
        for (const listener of this.#listeners) {
            listener(...values);
        }
    }
}
