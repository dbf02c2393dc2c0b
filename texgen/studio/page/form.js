// SPDX-License-Identifier: Apache-2.0

// The form of all preset keys: a section for each table of the schema, a search, filters, and a pane with help.

import {$, el} from "./dom.js";
import {applies} from "./conditions.js";
import {FormRow} from "./form_row.js";
import {showHelp} from "./form_help.js";
import {toToml} from "./toml.js";

const kOpenStore = "foamtex-studio-sections"; // key in localStorage

const kClosed = new Set(["preset", "image", "output"]); // sections that are closed at first

export class Form {
    #state;
    #sections;
    #rows = new Map();
    #values = {};
    #chosen = loadChosen();

    /**
     * Creates the controls of all keys. `tables` is the result of `tablesOf` (schema.js). `largestFoam` is the upper
     * limit of the slider of the key `foam.bubbles`.
     */
    constructor(tables, state, largestFoam) {
        this.#state = state;
        this.#sections = tables.map((table) => this.#section(table, largestFoam));
        $("form").replaceChildren(...this.#sections.map((section) => section.element));
        $("form-search").addEventListener("input", () => this.#filter());
        $("form-changed").addEventListener("click", () => this.#toggle("form-changed"));
        $("form-all").addEventListener("click", () => this.#toggle("form-all"));
        $("form-reset").addEventListener("click", () => this.#state.reset(this.#state.changes.map(([key]) => key)));
    }

    /** Shows the values of an answer of /api/settings. */
    showAnswer(answer) {
        this.#values = answer.values;
        for (const row of this.#rows.values()) {
            row.showError(null);
            row.showValue(answer.values[row.key.path], this.#state.change(row.key.path));
        }
        this.#showNotes(answer.notes);
        this.#showGeneral(null);
        this.#filter();
    }

    /**
     * Opens the section "foam", and each section with a key whose value in the preset is not the
     * default, except the sections of kClosed. Closes the other sections. A section that the user
     * has opened or closed stays as the user chose. `base` contains the values of the preset.
     */
    showPreset(base) {
        for (const section of this.#sections) {
            const differs =
                !kClosed.has(section.name) &&
                section.keys.some(
                    (key) => base[key.path] !== undefined && toToml(base[key.path]) !== toToml(key.default),
                );
            section.set(this.#chosen[section.name] ?? (differs || section.name === "foam"));
        }
        this.#filter();
    }

    /** Shows an error of the program in the row of its key, or above the form if it is about no key of the form. */
    showError(error) {
        const row = this.#rows.get(error?.key);
        for (const other of this.#rows.values()) {
            other.showError(other === row ? error.message : null);
        }
        this.#showGeneral(row || !error ? null : error.message);
        if (row) {
            this.#sections.find((section) => section.name === row.key.table).set(true);
        }
        this.#filter();
    }

    /** Marks the changed keys. Does not wait for the answer of the server. */
    showChanges() {
        for (const row of this.#rows.values()) {
            row.showChanged(this.#state.change(row.key.path) !== undefined);
        }
    }

    /** Scrolls to the first section. */
    scrollToTop() {
        $("form").parentElement.scrollTop = 0;
    }

    /** Moves the focus to the control of a key and makes it visible. */
    focus(path) {
        const row = this.#rows.get(path);
        if (row) {
            this.#sections.find((section) => section.name === row.key.table).set(true);
            row.element.hidden = false;
            row.element.scrollIntoView({block: "nearest"});
            row.field.control.focus();
        }
    }

    /** The key of the row that contains the focus, or null. */
    get focusedKey() {
        return document.activeElement?.closest?.("[data-row]")?.dataset.row ?? null;
    }

    #section(table, largestFoam) {
        const rows = table.keys.map((key) => this.#row(key, largestFoam));
        const body = el("div", {class: "section-body", id: `section-${table.name}`}, ...rows.map((row) => row.element));
        const count = el("span", {class: "count"});
        const head = el(
            "button",
            {type: "button", class: "section-head", "aria-controls": body.id, "aria-expanded": "false"},
            el("span", {class: "section-name"}, title(table.name)),
            count,
        );
        const element = el("section", {class: "section", data: {table: table.name}}, el("h3", {}, head), body);
        const section = {name: table.name, keys: table.keys, rows, element, count, open: false};
        section.set = (open) => {
            section.open = open;
            this.#showOpen(section);
        };
        section.show = (open) => {
            head.setAttribute("aria-expanded", String(open));
            body.hidden = !open;
        };
        head.addEventListener("click", () => this.#choose(section));
        return section;
    }

    #choose(section) {
        section.set(!section.open);
        this.#chosen[section.name] = section.open;
        localStorage.setItem(kOpenStore, JSON.stringify(this.#chosen));
    }

    #row(key, largestFoam) {
        const row = new FormRow(key, {
            edit: (text, {gesture = null, live = false}) => this.#state.set(key.path, text, gesture, live),
            reset: () => this.#state.reset([key.path]),
            largest: key.path === "foam.bubbles" ? largestFoam : undefined,
        });
        row.element.addEventListener("focusin", () => showHelp(key, this.#values));
        row.element.addEventListener("pointerenter", () => showHelp(key, this.#values));
        this.#rows.set(key.path, row);
        return row;
    }

    #toggle(id) {
        $(id).setAttribute("aria-pressed", String($(id).getAttribute("aria-pressed") !== "true"));
        this.#filter();
    }

    get #words() {
        return $("form-search")
            .value.toLowerCase()
            .split(/\s+/)
            .filter((word) => word !== "");
    }

    #filter() {
        const words = this.#words;
        const onlyChanged = $("form-changed").getAttribute("aria-pressed") === "true";
        const all = $("form-all").getAttribute("aria-pressed") === "true" || words.length > 0;
        let found = 0;
        for (const section of this.#sections) {
            for (const row of section.rows) {
                const used = applies(row.key, this.#values);
                row.showUsed(used);
                row.element.hidden =
                    !(row.matches(words) && (used || all || row.changed || row.invalid)) ||
                    (onlyChanged && !row.changed && !row.invalid);
            }
            const visible = section.rows.filter((row) => !row.element.hidden).length;
            found += visible;
            section.element.hidden = visible === 0;
            this.#showOpen(section, words.length > 0 || onlyChanged);
        }
        $("form-none").hidden = found > 0;
        this.#count();
    }

    #showOpen(section, force = this.#words.length > 0) {
        section.show(force || section.open);
    }

    #count() {
        for (const section of this.#sections) {
            const changed = section.rows.filter((row) => row.changed).length;
            section.count.textContent = changed > 0 ? String(changed) : "";
            section.count.title = changed > 0 ? `${changed} changed` : "";
        }
        $("form-reset").disabled = this.#state.changes.length === 0;
    }

    #showNotes(notes) {
        for (const row of this.#rows.values()) {
            row.showNote(notes.find((note) => note.startsWith(`${row.key.path} `)) ?? null);
        }
    }

    #showGeneral(message) {
        $("form-error").hidden = !message;
        $("form-error").textContent = message ?? "";
    }
}

const kTitles = {lit: "Light", thin_film: "Thin film", event_map: "Event map", preset: "Preset"};
const title = (table) => kTitles[table] ?? table[0].toUpperCase() + table.slice(1);

function loadChosen() {
    try {
        return JSON.parse(localStorage.getItem(kOpenStore)) ?? {};
    } catch {
        return {};
    }
}
