// SPDX-License-Identifier: Apache-2.0

// Shows the events on a track below the time line, where the user adds, moves, lengthens, shortens,
// selects and deletes them.

import {$, clamp, el} from "./dom.js";
import {EventEditor} from "./event_editor.js";
import {kindOf, newEvent, rangeOf, toTexts, withRange} from "./event_model.js";

const kRow = 16; // height of an event on the track, including the gap, in CSS pixels
const kEdge = 7; // width of the handle at each end of an event, in CSS pixels; dragging a handle changes the length

const kLoopsWithEvents = ["none", "pingpong"]; // the values of loop.kind with which the program allows events

export class EventTrack {
    #studio;
    #selected = null;
    #drag = null;
    #error = null;

    constructor(studio) {
        this.#studio = studio;
        this.editor = new EventEditor(studio, this);
        $("event-add").addEventListener("click", () => this.add());
        studio.answered.on(() => {
            this.#error = null;
            this.#show();
        });
        studio.rejected.on((error) => this.#onError(error));
        studio.state.changed.on((change) => change.opened && this.select(null));
        studio.refreshed.on(() => studio.baked && this.select(null));
        studio.refreshed.on(() => {
            $("event-add").disabled = Boolean(studio.baked);
        });
        this.#show();
    }

    /** The events of the document (state.js) as the page keeps them (event_model.js); none if a baked set is shown. */
    get list() {
        if (this.#studio.baked) {
            return [];
        }
        return this.#studio.state.events ?? toTexts(this.#studio.answer?.events ?? []);
    }

    get selected() {
        return this.#selected;
    }

    /** The program's error about an event: {index, key, message}, or null if there is none. */
    get error() {
        return this.#error;
    }

    /** Adds an event at the current frame and opens it. */
    add() {
        const {player, eventKinds, status} = this.#studio;
        const obstacle = this.#obstacle();
        if (obstacle) {
            status.say(obstacle);
            return;
        }
        this.#replace([...this.list, newEvent(eventKinds[0], player.frame, player.count)]);
        this.select(this.list.length - 1);
    }

    // Returns the reason why no event can be added, as a sentence; null if one can be added.
    #obstacle() {
        const {player, answer, baked} = this.#studio;
        if (baked) {
            return "Baked images cannot be edited; open a preset to add events.";
        }
        if (player.count < 2) {
            return "Events need an animation of at least two frames.";
        }
        const loop = answer?.values["loop.kind"];
        return loop === undefined || kLoopsWithEvents.includes(loop)
            ? null
            : `Events need loop.kind = "none" or "pingpong", not "${loop}": this loop must return to its first frame by itself.`;
    }

    /** Replaces an event, or removes it if `event` is null. */
    change(index, event) {
        this.#replace(event === null ? this.list.toSpliced(index, 1) : this.list.with(index, event));
        if (event === null) {
            this.select(null);
        }
    }

    /** Selects an event and opens its editor; null closes the editor. */
    select(index) {
        this.#selected = index;
        this.#show();
    }

    #replace(events) {
        this.#studio.state.setEvents(events);
        this.#show();
    }

    // In errors of the program, the key of an event contains the event's number: event[1].frames.
    #onError(error) {
        const found = /^event(?:\[(\d+)\])?/.exec(error.key ?? "");
        if (found) {
            this.#error = {index: Number(found[1] ?? 0) - 1, key: error.key.split(".")[1], message: error.message};
            this.#show();
        }
    }

    #show() {
        if (this.#drag) {
            return;
        }
        const {player, answer} = this.#studio;
        const rows = [];
        const focused = $("events").contains(document.activeElement) ? document.activeElement.dataset.event : null;
        const marks = this.list.map((event, index) => {
            const [first, last] = rangeOf(event, answer?.values ?? {});
            const row = rows.findIndex((end) => end < first);
            const slot = row < 0 ? rows.length : row;
            rows[slot] = last;
            return this.#mark(event, index, first, last, slot, player.count);
        });
        $("events").replaceChildren(...marks);
        $("events").style.height = `${kRow * Math.max(1, rows.length)}px`;
        $("events-none").hidden = marks.length > 0;
        if (focused !== null) {
            $("events").querySelector(`[data-event="${focused}"]`)?.focus();
        }
        this.editor.show(this.#selected, this.list[this.#selected] ?? null);
    }

    #mark(event, index, first, last, row, count) {
        const kind = kindOf(event);
        const frames = first === last ? `frame ${first}` : `frames ${first} to ${last}`;
        const mark = el(
            "button",
            {
                type: "button",
                class: "event",
                data: {event: index, kind},
                "aria-label": `Event ${index + 1}: ${kind}, ${frames}`,
                title: `${kind}, ${frames}`,
                "aria-pressed": String(index === this.#selected),
            },
            el("span", {}, kind),
        );
        mark.classList.toggle("wrong", this.#error?.index === index);
        this.#placeMark(mark, first, last, row, count);
        mark.addEventListener("pointerdown", (pointer) => this.#start(pointer, mark, index, [first, last]));
        mark.addEventListener("pointermove", (pointer) => this.#move(pointer, row));
        mark.addEventListener("pointerup", () => this.#end());
        mark.addEventListener("click", () => this.select(index));
        mark.addEventListener("keydown", (key) => this.#key(key, index, [first, last]));
        return mark;
    }

    #placeMark(mark, first, last, row, count) {
        mark.style.left = `${(100 * (first - 1)) / count}%`;
        mark.style.width = `${(100 * (last - first + 1)) / count}%`;
        mark.style.top = `${kRow * row}px`;
    }

    #start(pointer, mark, index, range) {
        const box = mark.getBoundingClientRect();
        const x = pointer.clientX - box.left;
        const part = box.width < 3 * kEdge ? "all" : x < kEdge ? "first" : x > box.width - kEdge ? "last" : "all";
        mark.setPointerCapture(pointer.pointerId);
        this.#drag = {mark, index, part, start: pointer.clientX, range, moved: range};
    }

    #move(pointer, row) {
        const drag = this.#drag;
        if (!drag) {
            return;
        }
        const {count} = this.#studio.player;
        const step = Math.round(((pointer.clientX - drag.start) / $("events").clientWidth) * count);
        drag.moved = moved(drag.range, drag.part, step, count);
        this.#placeMark(drag.mark, ...drag.moved, row, count);
    }

    #end() {
        const drag = this.#drag;
        this.#drag = null;
        if (drag && drag.moved.join() !== drag.range.join()) {
            this.change(drag.index, withRange(this.list[drag.index], drag.moved));
        }
    }

    #key(key, index, range) {
        const step = {ArrowLeft: -1, ArrowRight: 1}[key.key];
        if (key.key === "Delete" || key.key === "Backspace") {
            this.change(index, null);
        } else if (step) {
            const to = moved(range, key.shiftKey ? "last" : "all", step, this.#studio.player.count);
            this.change(index, withRange(this.list[index], to));
        } else {
            return;
        }
        key.preventDefault();
        key.stopPropagation();
    }
}

// Returns the new frames [first, last] of an event after its first frame, its last frame or both are
// moved by `step` frames; `part` is "first", "last" or "all". Events begin at frame 2 or later.
function moved([first, last], part, step, count) {
    if (part === "first") {
        return [clamp(first + step, 2, last), last];
    }
    if (part === "last") {
        return [first, clamp(last + step, first, count)];
    }
    const offset = clamp(step, 2 - first, count - last);
    return [first + offset, last + offset];
}
