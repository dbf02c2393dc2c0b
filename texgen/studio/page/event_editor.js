// SPDX-License-Identifier: Apache-2.0

// The panel that edits one event: its kind, its frames, and the keys of its kind.

import {$, el, icon} from "./dom.js";
import {FormRow} from "./form_row.js";
import {fromToml} from "./toml.js";
import {kindOf, rangeOf, withKind, withRange, withValue} from "./event_model.js";
import {showHelp} from "./form_help.js";

const kTimes = ["frame", "frames", "time"];

export class EventEditor {
    #studio;
    #track;
    #rows = [];
    #kind = null;
    #index = null;
    #picking = false;

    constructor(studio, track) {
        this.#studio = studio;
        this.#track = track;
        $("event-kind").replaceChildren(
            ...studio.eventKinds.map((kind) => el("option", {value: kind.name}, kind.name)),
        );
        $("event-kind").addEventListener("change", () =>
            this.#change((event) => withKind(event, this.#kindNamed($("event-kind").value))),
        );
        for (const id of ["event-first", "event-last"]) {
            $(id).addEventListener("change", () => this.#changeRange());
        }
        $("event-delete").addEventListener("click", () => track.change(this.#index, null));
        $("event-close").addEventListener("click", () => track.select(null));
        $("event-editor").addEventListener("keydown", (event) => this.#key(event));
        studio.view.gestures.clicked.on((point) => this.#onClick(point));
        studio.view.moved.on(() => this.#placePin());
    }

    /**
     * Shows `event`, the event with the given index in the list of the track (EventTrack, events.js), or closes the
     * panel if `event` is null.
     */
    show(index, event) {
        this.#index = event ? index : null;
        $("event-editor").hidden = !event;
        this.#pick(this.#picking && event !== null);
        if (event) {
            this.#showEvent(event);
        }
        this.#placePin();
    }

    get #event() {
        return this.#index === null ? null : (this.#track.list[this.#index] ?? null);
    }

    #kindNamed = (name) => this.#studio.eventKinds.find((kind) => kind.name === name);

    #showEvent(event) {
        const kind = this.#kindNamed(kindOf(event));
        const [first, last] = rangeOf(event, this.#studio.answer?.values ?? {});
        $("event-title").textContent = `Event ${this.#index + 1}`;
        $("event-kind").value = kind.name;
        $("event-help").textContent = `${kind.help.replaceAll("`", "")}.`;
        $("event-first").value = first;
        $("event-last").value = last;
        if (kind !== this.#kind) {
            this.#kind = kind;
            this.#rows = kind.keys.filter((key) => !kTimes.includes(key.name)).map((key) => this.#row(key));
            $("event-rows").replaceChildren(...this.#rows.map((row) => row.element));
        }
        this.#showValues(event);
    }

    #showValues(event) {
        const error = this.#track.error?.index === this.#index ? this.#track.error : null;
        for (const row of this.#rows) {
            const text = event[row.key.name];
            row.showValue(text === undefined ? row.key.default : fromToml(text), text);
            row.showError(error?.key === row.key.name ? error.message : null);
        }
        const general = error && !this.#rows.some((row) => row.key.name === error.key);
        $("event-error").hidden = !general;
        $("event-error").textContent = general ? error.message : "";
    }

    #row(key) {
        const row = new FormRow(
            {...key, path: `event.${key.name}`},
            {
                prefix: "e",
                edit: (text) => this.#change((event) => withValue(event, key.name, text)),
                reset: () => this.#change((event) => withValue(event, key.name, null)),
            },
        );
        row.element.addEventListener("focusin", () => showHelp({...key, condition: null}, {}));
        if (key.name === "at") {
            const button = el(
                "button",
                {
                    type: "button",
                    class: "small-button",
                    id: "event-pick",
                    "aria-pressed": "false",
                    onclick: () => this.#pick(!this.#picking),
                },
                icon("target"),
                "Pick in the picture",
            );
            row.element.append(button);
        }
        return row;
    }

    #change(edit) {
        if (this.#event) {
            this.#track.change(this.#index, edit(this.#event));
        }
    }

    #changeRange() {
        const [first, last] = [Number($("event-first").value), Number($("event-last").value)];
        this.#change((event) => withRange(event, [first, Math.max(first, last)]));
    }

    #key(event) {
        if (event.key === "Escape") {
            event.stopPropagation();
            this.#picking ? this.#pick(false) : this.#track.select(null);
        }
    }

    // Begins or ends the picking of a position. While it lasts, the next click in the picture sets
    // the position.
    #pick(on) {
        this.#picking = on;
        this.#studio.readout.suspended = on;
        $("picture").classList.toggle("picking", on);
        $("event-pick")?.setAttribute("aria-pressed", String(on));
        if (on) {
            this.#studio.status.say("Click in the picture to set the position of the event.");
        }
    }

    // Positions of events are fractions of the width and the height, from the lower left corner.
    #onClick([x, y]) {
        if (this.#picking) {
            this.#pick(false);
            this.#change((event) => withValue(event, "at", `[${x.toFixed(4)}, ${(1 - y).toFixed(4)}]`));
        }
    }

    #placePin() {
        const at = this.#event?.at && fromToml(this.#event.at);
        $("pin").hidden = !Array.isArray(at);
        if (Array.isArray(at)) {
            const [x, y] = this.#studio.view.positionOf(at[0], 1 - at[1]);
            $("pin").style.left = `${x}px`;
            $("pin").style.top = `${y}px`;
        }
    }
}
