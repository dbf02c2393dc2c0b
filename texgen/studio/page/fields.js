// SPDX-License-Identifier: Apache-2.0

// Creates the control of a key, by the kind of the key. A control is an object with `element` (the element to insert
// into the page), `control` (the element that carries the value and the attribute data-key), `show(value, text)`,
// `busy()` (true while the user edits the value), and `wide` (true if the control needs a whole row).

import {colorField, colorsField} from "./field_colors.js";
import {numberField} from "./field_number.js";
import {el} from "./dom.js";
import {formatNumber} from "./scale.js";
import {toToml} from "./toml.js";

// If a key has more choices than kSegments, or if they have more letters in all than kSegmentLetters, its control
// is a menu instead of radio buttons.
const kSegments = 3;
const kSegmentLetters = 22;

const never = () => false;

/**
 * Creates the control of a key. The control calls `edit(text, {gesture, live})` with the new value in TOML. Edits with
 * the same `gesture` are undone together; `live` is true while a slider is being dragged or a color is being picked.
 * `options.label` is the accessible name of the control; `options.largest` limits sliders.
 */
export function createField(key, id, edit, options) {
    const create = {
        number: numberField,
        color: colorField,
        colors: colorsField,
        choice: choiceField,
        choices: choicesField,
        numbers: numbersField,
        texts: textsField,
        text: textField,
    }[key.kind];
    return create(key, id, edit, options);
}

function choiceField(key, id, edit, options) {
    const letters = key.choices.join("").length;
    const few = key.choices.length <= kSegments && letters <= kSegmentLetters;
    return few ? segmentsField(key, id, edit, options) : menuField(key, id, edit, options);
}

function menuField(key, id, edit, {label}) {
    const menu = el(
        "select",
        {id, "aria-label": label, data: {key: key.path}},
        ...key.choices.map((choice) => el("option", {value: choice}, choice)),
    );
    menu.addEventListener("change", () => edit(toToml(menu.value), {}));
    return {
        element: menu,
        control: menu,
        show: (value) => {
            menu.value = value;
        },
        busy: never,
    };
}

function segmentsField(key, id, edit, {label}) {
    const radios = key.choices.map((choice) => el("input", {type: "radio", name: id, value: choice}));
    const group = el(
        "div",
        {class: "segments", role: "radiogroup", id, "aria-label": label, data: {key: key.path}},
        ...radios.map((radio) => el("label", {}, radio, el("span", {}, radio.value))),
    );
    group.addEventListener("change", (event) => edit(toToml(event.target.value), {}));
    const show = (value) =>
        radios.forEach((radio) => {
            radio.checked = radio.value === value;
        });
    return {element: group, control: group, show, busy: never};
}

// Several choices out of a list, such as maps: buttons that are switched on and off.
function choicesField(key, id, edit, {label}) {
    let chosen = [];
    const chips = key.choices.map((choice) =>
        el("button", {type: "button", class: "chip", "aria-pressed": "false", data: {item: choice}}, choice),
    );
    const group = el("div", {class: "chips", role: "group", id, "aria-label": label, data: {key: key.path}}, ...chips);
    const show = (value) => {
        chosen = Array.isArray(value) ? value : [value];
        chips.forEach((chip) => chip.setAttribute("aria-pressed", String(chosen.includes(chip.dataset.item))));
    };
    group.addEventListener("click", (event) => {
        const item = event.target.closest(".chip")?.dataset.item;
        if (item) {
            show(chosen.includes(item) ? chosen.filter((one) => one !== item) : [...chosen, item]);
            edit(toToml(chosen), {});
        }
    });
    return {element: group, control: group, wide: true, show, busy: never};
}

// A list of numbers. A list of fixed length, such as a width and a height, has a field for each
// number; any other list has one field. A text that is no number is sent to the server too, whose
// error message then says what is wrong.
function numbersField(key, id, edit, options) {
    return key.length === null ? numberListField(key, id, edit, options) : fixedNumbersField(key, id, edit, options);
}

// An input for text. `more` contains further attributes.
const textInput = (key, id, label, more = {}) =>
    el("input", {
        type: "text",
        id,
        spellcheck: "false",
        autocomplete: "off",
        "aria-label": label,
        data: {key: key.path},
        ...more,
    });

// Any number of numbers, separated by commas. An empty text removes the value.
function numberListField(key, id, edit, {label}) {
    const input = textInput(key, id, label, {placeholder: "such as 4, 5"});
    input.addEventListener("change", () => {
        const items = input.value
            .split(",")
            .map((item) => item.trim())
            .filter((item) => item !== "");
        edit(items.length === 0 ? null : `[${items.map(numberText).join(", ")}]`, {});
    });
    return {
        element: input,
        control: input,
        busy: () => document.activeElement === input,
        show: (value) => {
            input.value = [value ?? []].flat().join(", ");
        },
    };
}

const numberText = (text) => (text.trim() !== "" && Number.isFinite(Number(text)) ? text.trim() : toToml(text.trim()));

function fixedNumbersField(key, id, edit, {label}) {
    const names = key.name === "size" ? ["width", "height"] : ["first", "second"];
    const inputs = Array.from({length: key.length ?? 1}, (_, index) =>
        el("input", {
            type: "text",
            inputmode: "decimal",
            class: "number",
            spellcheck: "false",
            autocomplete: "off",
            "aria-label": `${label}, ${names[index] ?? index + 1}`,
            data: {item: index},
        }),
    );
    const group = el(
        "div",
        {class: "numbers", role: "group", id, "aria-label": label, data: {key: key.path}},
        ...inputs,
    );
    group.addEventListener("change", () => edit(`[${inputs.map((input) => numberText(input.value)).join(", ")}]`, {}));
    const show = (value) =>
        inputs.forEach((input, index) => {
            const item = Array.isArray(value) ? value[index] : value;
            input.value = typeof item === "number" ? formatNumber(item) : (item ?? "");
        });
    return {element: group, control: group, show, busy: () => inputs.includes(document.activeElement)};
}

function textField(key, id, edit, {label}) {
    const input = textInput(key, id, label);
    input.addEventListener("change", () => edit(toToml(input.value), {}));
    return {
        element: input,
        control: input,
        wide: true,
        show: (value) => {
            input.value = value ?? "";
        },
        busy: () => document.activeElement === input,
    };
}

// A list of texts, one in each line.
function textsField(key, id, edit, {label}) {
    const area = el("textarea", {
        id,
        rows: 2,
        spellcheck: "false",
        "aria-label": label,
        placeholder: "one in each line",
        data: {key: key.path},
    });
    area.addEventListener("change", () => {
        edit(
            toToml(
                area.value
                    .split("\n")
                    .map((line) => line.trim())
                    .filter((line) => line !== ""),
            ),
            {},
        );
    });
    return {
        element: area,
        control: area,
        wide: true,
        show: (value) => {
            area.value = Array.isArray(value) ? value.join("\n") : (value ?? "");
        },
        busy: () => document.activeElement === area,
    };
}
