// SPDX-License-Identifier: Apache-2.0

import {createField} from "./fields.js";
import {el, iconButton} from "./dom.js";

const kLabeled = new Set(["INPUT", "SELECT", "TEXTAREA"]);

// Messages of the program begin with the option --set and its argument. The page removes both,
// because its users do not type options.
const withoutOption = (message) => message.replace(/^--set .*?: (?=key ')/, "");

/** A row of a form: the name of a key, its control, a button that resets the key, and a message. */
export class FormRow {
    changed = false;
    invalid = false;

    /**
     * Creates the row. `edit(text, {gesture, live})` is called with a value in TOML. Edits with the same `gesture` are
     * undone together; `live` is true while a control is being dragged. `reset()` removes the user's change of the key.
     * `largest` limits a slider; the ids of the elements begin with `prefix`.
     */
    constructor(key, {edit, reset, largest, prefix = "f"}) {
        this.key = key;
        const id = `${prefix}-${key.path.replaceAll(/[^a-z0-9_]/g, "-")}`;
        const name = key.name.replaceAll("_", " ");
        const label = `${key.table.replaceAll("_", " ")}: ${name}`;
        this.field = createField(key, id, edit, {largest, label});
        this.message = el("p", {class: "message", id: `${id}-message`, hidden: true, role: "status"});
        this.resetButton =
            reset && iconButton("reset", `Reset ${key.path}`, reset, {hidden: true, data: {reset: key.path}});
        const caption = kLabeled.has(this.field.control.tagName)
            ? el("label", {for: id}, name)
            : el("span", {class: "label"}, name);
        this.element = el(
            "div",
            {class: this.field.wide ? "row wide" : "row", data: {row: key.path}},
            caption,
            this.field.element,
            el("span", {class: "reset-place"}, this.resetButton),
            this.message,
        );
        this.text = `${key.path} ${name} ${key.help}`.toLowerCase();
    }

    /**
     * Shows the value of the key. `text` is the changed value in TOML, or undefined if the key is
     * not changed. A control that the user is editing keeps its content.
     */
    showValue(value, text) {
        this.showChanged(text !== undefined);
        if (!this.field.busy()) {
            this.field.show(value, text);
        }
    }

    showChanged(changed) {
        this.changed = changed;
        this.element.classList.toggle("changed", changed);
        if (this.resetButton) {
            this.resetButton.hidden = !changed;
        }
    }

    /** Marks the row as unused if the key has no effect. */
    showUsed(used) {
        this.element.classList.toggle("unused", !used);
    }

    /** Shows the program's message about a wrong value; null removes it. */
    showError(message) {
        this.invalid = message !== null;
        this.element.classList.toggle("invalid", this.invalid);
        this.field.control.toggleAttribute("data-invalid", this.invalid);
        if (kLabeled.has(this.field.control.tagName)) {
            this.field.control.setAttribute("aria-invalid", String(this.invalid));
        }
        this.#showMessage(message && withoutOption(message));
    }

    /** Shows a note of the program, such as that a change has no effect. */
    showNote(note) {
        if (!this.invalid) {
            this.#showMessage(note);
        }
    }

    /**
     * Returns true if the path, the name and the help text of the key together contain all words.
     */
    matches(words) {
        return words.every((word) => this.text.includes(word));
    }

    #showMessage(message) {
        this.message.hidden = message === null;
        this.message.textContent = message ?? "";
        if (message === null) {
            this.field.control.removeAttribute("aria-describedby");
        } else {
            this.field.control.setAttribute("aria-describedby", this.message.id);
        }
    }
}
