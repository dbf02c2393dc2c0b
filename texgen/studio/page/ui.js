// SPDX-License-Identifier: Apache-2.0

const kStore = "foamtex-studio-view"; // key in sessionStorage

const kDefaults = {
    map: null, // the map that is shown; null shows the first map of the preset
    tiling: 1, // copies of the tile in each direction
    width: -1, // largest width of pictures, in pixels; 0 is the size of the preset, -1 suits the window
    frame: 1,
    speed: 1,
    mode: "picture", // what the workspace shows: picture, lit or variations
    compare: false,
    gallery: true, // whether the gallery is open
};

/** How the page shows the document: values that are no part of presets. They survive a reload, but are not undone. */
export class Ui {
    #values = {...kDefaults};
    #listeners = new Map();

    constructor() {
        try {
            Object.assign(this.#values, JSON.parse(sessionStorage.getItem(kStore)));
        } catch {
            // What another version of the page stored is ignored.
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
            // A full storage does not matter here.
        }
        for (const listener of this.#listeners.get(name) ?? []) {
            listener(value);
        }
    }

    /** Calls the listener with the new value whenever one of the names changes. */
    on(names, listener) {
        for (const name of [names].flat()) {
            this.#listeners.set(name, [...(this.#listeners.get(name) ?? []), listener]);
        }
    }
}
