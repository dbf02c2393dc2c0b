// SPDX-License-Identifier: Apache-2.0

const kStore = "foamtex-studio-view"; // key in sessionStorage

const kDefaults = {
    map: null, // the map that is shown; null shows the first map of the preset
    tiling: 1, // copies of the tile in each direction
    width: -1, // largest width of pictures, in pixels; 0 is the size of the preset, -1 suits the window
    frame: 1,
    speed: 1,
    mode: "picture", // what the workspace shows: "picture", "lit" or "variations"
    compare: false,
    gallery: true, // true if the gallery is open
};

/**
 * Values that determine how the page shows the document of the studio: the preset and its changes
 * (state.js). The values are not part of presets. They survive a reload; undo does not change them.
 */
export class Ui {
    #values = {...kDefaults};
    #listeners = new Map();

    constructor() {
        try {
            Object.assign(this.#values, JSON.parse(sessionStorage.getItem(kStore)));
        } catch {
            // Without access to the storage, or if its text is not JSON, the defaults apply.
        }
    }

    /** Returns a value. */
    get(name) {
        return this.#values[name];
    }

    /** Sets a value and calls the listeners if it differs from before. */
    set(name, value) {
        if (this.#values[name] === value) {
            return;
        }
        this.#values[name] = value;
        try {
            sessionStorage.setItem(kStore, JSON.stringify(this.#values));
        } catch {
            // If the storage is full, the new value is only lost at the next reload.
        }
        for (const listener of this.#listeners.get(name) ?? []) {
            listener(value);
        }
    }

    /** Calls the listener with the new value whenever the value of one of `names` (a name or an array) changes. */
    on(names, listener) {
        for (const name of [names].flat()) {
            this.#listeners.set(name, [...(this.#listeners.get(name) ?? []), listener]);
        }
    }
}
