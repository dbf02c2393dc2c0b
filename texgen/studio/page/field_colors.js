// SPDX-License-Identifier: Apache-2.0

// The controls of one color and of a list of colors.

import {el, iconButton} from "./dom.js";
import {toToml} from "./toml.js";

let gestures = 0;

/** Splits "#rrggbb@0.25" into "#rrggbb" and "@0.25". The second part is empty if the text has no position. */
function splitColor(text) {
    const at = text.indexOf("@");
    return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at)];
}

// Returns a color of a list as CSS writes it in a gradient: "#rrggbb 25%".
function cssStop(text) {
    const [color, position] = splitColor(text);
    return position ? `${color} ${100 * Number(position.slice(1))}%` : color;
}

// Returns "#rrggbb" for "#rgb" and for colors without "#". Other texts are only trimmed: the page sends them to the
// program, whose error message tells what is wrong.
function fullColor(text) {
    const [color, position] = splitColor(text.trim());
    const digits = color.trim().replace(/^#/, "");
    if (/^[0-9a-fA-F]{3}$/.test(digits)) {
        return `#${[...digits].map((digit) => digit + digit).join("")}${position}`;
    }
    return /^[0-9a-fA-F]{6}$/.test(digits) ? `#${digits}${position}` : text.trim();
}

/**
 * Creates a picker and a text field that edit one color. `edit(color, {gesture, live})` gets "#rrggbb" or, in a list,
 * "#rrggbb@position".
 */
function colorEditor(label, edit, properties = {}) {
    const picker = el("input", {type: "color", class: "swatch", "aria-label": `${label}, picker`});
    const text = el("input", {
        type: "text",
        class: "hex",
        spellcheck: "false",
        autocomplete: "off",
        maxlength: "16",
        "aria-label": label,
        ...properties,
    });
    let gesture = null;
    picker.addEventListener("input", () => {
        gesture ??= `color ${++gestures}`;
        text.value = picker.value + splitColor(text.value)[1];
        edit(text.value, {gesture, live: true});
    });
    picker.addEventListener("change", () => {
        edit(picker.value + splitColor(text.value)[1], {gesture, live: false});
        gesture = null;
    });
    text.addEventListener("change", () => {
        text.value = fullColor(text.value);
        edit(text.value, {});
    });
    const show = (color) => {
        text.value = color;
        const [plain] = splitColor(color);
        if (/^#[0-9a-f]{6}$/i.test(plain)) {
            picker.value = plain;
        }
    };
    return {picker, text, show, busy: () => gesture !== null};
}

/** Creates the control of a key that is one color. */
export function colorField(key, id, edit, {label}) {
    const editor = colorEditor(label, (color, how) => edit(toToml(color), how), {id, data: {key: key.path}});
    return {
        element: el("div", {class: "field-color"}, editor.picker, editor.text),
        control: editor.text,
        show: (value) => editor.show(value ?? ""),
        busy: editor.busy,
    };
}

/**
 * The control of a key that is a list of colors: swatches, of which one is selected and can be edited, moved or
 * removed.
 */
class ColorList {
    #edit;
    #colors = [];
    #selected = 0;

    constructor(key, edit, label) {
        this.#edit = edit;
        this.swatches = el("div", {class: "swatches"});
        this.ramp = el("div", {class: "ramp", "aria-hidden": "true"});
        this.editor = colorEditor(`${label}, selected color`, (color, how) => this.#replace(color, how));
        const button = (name, text, action) => iconButton(name, `${label}: ${text}`, action);
        this.tools = el(
            "div",
            {class: "color-tools"},
            this.editor.picker,
            this.editor.text,
            button("left", "move the color to the left", () => this.#move(-1)),
            button("right", "move the color to the right", () => this.#move(1)),
            button("minus", "remove the color", () => this.#remove()),
        );
        this.add = button("plus", "add a color", () => this.#add());
        this.control = el(
            "div",
            {class: "field-colors", role: "group", "aria-label": label, data: {key: key.path}},
            this.ramp,
            this.swatches,
            this.tools,
        );
    }

    show(value) {
        this.#colors = Array.isArray(value) ? value : value ? [value] : [];
        this.#selected = Math.max(0, Math.min(this.#selected, this.#colors.length - 1));
        this.#draw();
    }

    #draw() {
        const focused = this.swatches.contains(document.activeElement);
        this.swatches.replaceChildren(...this.#colors.map((color, index) => this.#swatch(color, index)), this.add);
        this.ramp.style.background =
            this.#colors.length > 1 ? `linear-gradient(to right, ${this.#colors.map(cssStop).join(",")})` : "";
        this.ramp.hidden = this.#colors.length < 2;
        this.tools.hidden = this.#colors.length === 0;
        if (this.#colors.length > 0) {
            this.editor.show(this.#colors[this.#selected]);
        }
        if (focused) {
            (this.swatches.children[this.#selected] ?? this.add).focus();
        }
    }

    #swatch(color, index) {
        const swatch = el("button", {
            type: "button",
            class: "list-swatch",
            draggable: "true",
            "aria-pressed": String(index === this.#selected),
            "aria-label": `Color ${index + 1} of ${this.#colors.length}: ${color}`,
            title: color,
            data: {item: index},
        });
        swatch.style.backgroundColor = splitColor(color)[0];
        swatch.addEventListener("click", () => this.#select(index));
        swatch.addEventListener("dblclick", () => this.editor.picker.click());
        swatch.addEventListener("keydown", (event) => this.#onKey(event));
        swatch.addEventListener("dragstart", () => this.#select(index, false));
        swatch.addEventListener("dragover", (event) => event.preventDefault());
        swatch.addEventListener("drop", (event) => {
            event.preventDefault();
            this.#move(index - this.#selected);
        });
        return swatch;
    }

    #onKey(event) {
        const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (event.key === "Delete" || event.key === "Backspace") {
            this.#remove();
        } else if (step && event.altKey) {
            this.#move(step);
        } else if (step) {
            this.#select(Math.max(0, Math.min(this.#selected + step, this.#colors.length - 1)));
        } else {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
    }

    // Drawing replaces the swatches. The swatch that a drag moves must stay in the page, so the
    // start of a drag selects without drawing.
    #select(index, draw = true) {
        this.#selected = index;
        if (draw) {
            this.#draw();
        }
    }

    #commit(colors, how = {}) {
        this.#colors = colors;
        this.#edit(toToml(colors), how);
        this.#draw();
    }

    #replace(color, how) {
        this.#commit(this.#colors.with(this.#selected, color), how);
    }

    #move(step) {
        const target = this.#selected + step;
        if (step === 0 || target < 0 || target >= this.#colors.length) {
            return;
        }
        const colors = [...this.#colors];
        const [moved] = colors.splice(this.#selected, 1);
        colors.splice(target, 0, moved);
        this.#selected = target;
        this.#commit(colors);
    }

    #remove() {
        this.#commit(this.#colors.filter((_, index) => index !== this.#selected));
    }

    // Adds a copy of the last color. An empty list starts with two colors, because one color alone is no scale.
    #add() {
        const colors = this.#colors.length === 0 ? ["#1f6d86", "#f4fbfa"] : [...this.#colors, splitColor(this.#colors.at(-1))[0]];
        this.#selected = colors.length - 1;
        this.#commit(colors);
    }
}

/** Creates the control of a key that is a list of colors. */
export function colorsField(key, id, edit, {label}) {
    const list = new ColorList(key, edit, label);
    list.control.id = id;
    return {
        element: list.control,
        control: list.control,
        wide: true,
        show: (value) => list.show(value),
        busy: list.editor.busy,
    };
}
