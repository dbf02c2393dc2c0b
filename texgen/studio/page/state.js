// SPDX-License-Identifier: Apache-2.0

// The document of the page: a preset, the changes to it, and its events. Every edit makes a new snapshot of the
// document, or replaces the latest snapshot if the edit belongs to the same gesture as the edit before it, such as the
// dragging of a control. Undo and redo therefore only move along the list of snapshots.

import {Signal} from "./signal.js";
import {eventsToToml, toToml} from "./toml.js";

const kLimit = 200; // snapshots that are kept
const kStore = "foamtex-studio-document"; // key in sessionStorage

// In a preset, setting one of these keys clears the other one. Only the key that was set last is
// therefore kept as a change.
const kRivals = {"albedo.colors": "albedo.colormap", "albedo.colormap": "albedo.colors"};

/**
 * Tables whose keys usually change the foam, and not only its looks; kLookKeys are exceptions. changesFoam is therefore
 * only a guess. If it is wrong, the pictures take longer, but they are right.
 */
const kFoamTables = /^(foam|dynamics|frames|loop|event)(\.|\[|$)/;
const kLookKeys = new Set(["frames.smoothing"]);

/** Returns true if an edit of the key probably needs another simulation. */
export const changesFoam = (key) => kFoamTables.test(key) && !kLookKeys.has(key);

function without(changes, key) {
    return changes.filter(([name]) => name !== key && name !== kRivals[key]);
}

export class StudioState {
    /**
     * Emits {foam, live, keys, opened} after every change. `foam` is true if the change probably needs another
     * simulation, `live` is true while a control is being dragged, `keys` lists the changed keys ("event" stands for
     * the events), and `opened` is true if a preset or file has been opened, also by undo or redo.
     */
    changed = new Signal();

    /** The values of the preset without changes, by the path of the key; null while they are unknown. */
    base = null;

    #snapshots;
    #index = 0;
    #gesture = null;

    constructor(preset) {
        this.#snapshots = [{preset, changes: [], events: null}];
        this.#restore();
    }

    get #current() {
        return this.#snapshots[this.#index];
    }

    /** The name of the shipped preset or of the file. */
    get preset() {
        return this.#current.preset;
    }

    /** The changes to the preset, oldest first: pairs of a key and a value in TOML. */
    get changes() {
        return this.#current.changes;
    }

    /** The events that replace those of the preset, or null. */
    get events() {
        return this.#current.events;
    }

    get canUndo() {
        return this.#index > 0;
    }

    get canRedo() {
        return this.#index + 1 < this.#snapshots.length;
    }

    /** Returns the changed value of a key in TOML, or undefined. */
    change(key) {
        return this.changes.find(([name]) => name === key)?.[1];
    }

    /**
     * Returns the settings as the server expects them. `extra` lists more changes: pairs of a key and a value in TOML.
     */
    settings(extra = []) {
        const set = [...this.changes, ...extra].map(([key, text]) => `${key}=${text}`);
        return {preset: this.preset, set, events: this.events === null ? null : eventsToToml(this.events)};
    }

    /** Sets a key to a value in TOML. Edits with the same `gesture` are undone together. */
    set(key, text, gesture = null, live = false) {
        if (this.change(key) === text) {
            if (!live && gesture !== null) {
                // A drag has ended: the picture that was only drawn as a draft, or small, is now drawn in full.
                this.changed.emit({foam: changesFoam(key), live, keys: [key]});
            }
            return;
        }
        const kept = without(this.changes, key);
        this.#push({...this.#current, changes: this.#isBase(key, text) ? kept : [...kept, [key, text]]}, gesture);
        this.changed.emit({foam: changesFoam(key), live, keys: [key]});
    }

    // Returns true if the key has this value in the preset, so that setting the value is no change.
    #isBase(key, text) {
        const value = this.base?.[key];
        if (value === undefined || this.change(kRivals[key]) !== undefined) {
            return false;
        }
        return typeof value === "number" ? Number(text) === value : toToml(value) === text;
    }

    /** Gives keys the values that they have in the preset. */
    reset(keys) {
        this.#push({...this.#current, changes: this.changes.filter(([name]) => !keys.includes(name))});
        this.changed.emit({foam: keys.some(changesFoam), live: false, keys});
    }

    /** Replaces the events of the preset; null restores them. */
    setEvents(events, gesture = null, live = false) {
        this.#push({...this.#current, events}, gesture);
        this.changed.emit({foam: true, live, keys: ["event"]});
    }

    /** Opens a preset or a file, and begins without changes to it. */
    open(preset) {
        this.base = null;
        this.#push({preset, changes: [], events: null});
        this.changed.emit({foam: true, live: false, keys: [], opened: true});
    }

    undo() {
        this.#move(-1);
    }

    redo() {
        this.#move(1);
    }

    #move(step) {
        const before = this.#current;
        const index = this.#index + step;
        if (index < 0 || index >= this.#snapshots.length) {
            return;
        }
        this.#index = index;
        this.#gesture = null;
        this.#store();
        const keys = changedKeys(before, this.#current);
        const opened = before.preset !== this.preset;
        if (opened) {
            this.base = null;
        }
        this.changed.emit({foam: opened || keys.some(changesFoam), live: false, keys, opened});
    }

    #push(snapshot, gesture = null) {
        if (gesture !== null && gesture === this.#gesture) {
            this.#snapshots[this.#index] = snapshot;
        } else {
            this.#snapshots = [...this.#snapshots.slice(0, this.#index + 1), snapshot].slice(-kLimit);
            this.#index = this.#snapshots.length - 1;
        }
        this.#gesture = gesture;
        this.#store();
    }

    // Stores the snapshots after a short delay, so that they survive when the page is loaded again.
    #store() {
        clearTimeout(this.storing);
        this.storing = setTimeout(() => this.storeNow(), 200);
    }

    /** Writes the snapshots into the storage of this tab. */
    storeNow() {
        try {
            sessionStorage.setItem(kStore, JSON.stringify({snapshots: this.#snapshots, index: this.#index}));
        } catch {
            // The storage is full or switched off: the work is lost only if the page is loaded again.
        }
    }

    #restore() {
        try {
            const stored = JSON.parse(sessionStorage.getItem(kStore));
            if (stored?.snapshots?.[stored.index]?.preset) {
                this.#snapshots = stored.snapshots;
                this.#index = stored.index;
            }
        } catch {
            // Data that another version of the page has stored are ignored.
        }
    }
}

function changedKeys(before, after) {
    const keys = [];
    const old = new Map(before.changes);
    const now = new Map(after.changes);
    for (const key of new Set([...old.keys(), ...now.keys()])) {
        if (old.get(key) !== now.get(key)) {
            keys.push(key);
        }
    }
    if (before.events !== after.events) {
        keys.push("event");
    }
    return keys;
}
