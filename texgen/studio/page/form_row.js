// SPDX-License-Identifier: Apache-2.0

import {createField} from "./fields.js";
import {el, iconButton} from "./dom.js";

const kLabeled = new Set(["INPUT", "SELECT", "TEXTAREA"]);

// The program names the option --set at the start of a message, which the page has no use for.
const withoutOption = (message) => message.replace(/^--set .*?: (?=key ')/, "");

/** A row of a form: the name of a key, its control, a button that resets it, and a message. */
export class FormRow {
    changed = false;
    invalid = false;

    /**
     * Creates the row. `edit(text, {gesture, live})` gets a value in TOML; `reset()` restores the value of the preset.
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

    /** Shows a value, and the TOML text of the change if the key is changed. Does not disturb a control in use. */
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

    /** Shows a key without effect as such. */
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

    /** Returns true if the key contains all words in its path or its help text. */
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
