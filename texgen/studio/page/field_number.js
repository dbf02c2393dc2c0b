// SPDX-License-Identifier: Apache-2.0

// The control of a number: a slider, a text field, and for some keys a dice, or a switch for a word
// such as "auto".

import {clamp, el, iconButton} from "./dom.js";
import {formatNumber, scaleOf, stepOf} from "./scale.js";
import {toToml} from "./toml.js";

const kShortUnits = {pixels: "px", degrees: "°", nanometers: "nm", "percent of the bubbles": "%"};
const kPause = 800; // milliseconds after which another press of an arrow key is an edit of its own
const kRandomSeeds = 100000; // a random seed is below this number

// Returns the text of a field as a value in TOML. A text that is no number becomes a string, which is sent to the
// program, too: the program accepts it (a word such as "auto"), or its error message says what is wrong.
function textToToml(text) {
    const trimmed = text.trim();
    return trimmed !== "" && Number.isFinite(Number(trimmed)) ? trimmed : toToml(trimmed);
}

/**
 * Gives each gesture of the user a number. All edits by one drag have the same number, and so have edits by arrow keys
 * that follow each other within kPause. `held` is true during a drag.
 */
class Gesture {
    #number = 0;
    #last = 0;

    start() {
        this.#number = Gesture.next = (Gesture.next ?? 0) + 1;
        this.#last = performance.now();
    }

    get current() {
        if (performance.now() - this.#last > kPause && !this.held) {
            this.start();
        }
        this.#last = performance.now();
        return this.#number;
    }
}

/**
 * Creates the control of a number (fields.js explains controls). `edit(text, {gesture, live})` is
 * called with the value in TOML. Edits with the same `gesture` are undone together; `live` is true
 * while the slider is being dragged.
 */
export function numberField(key, id, edit, {largest, label}) {
    const scale = scaleOf(key, largest);
    const input = el("input", {
        type: "text",
        inputmode: "decimal",
        class: "number",
        id,
        spellcheck: "false",
        autocomplete: "off",
        "aria-label": label,
        data: {key: key.path},
    });
    const slider = scale && sliderFor(key, scale, input, edit, label);
    const unit = kShortUnits[key.unit];
    const box = el(
        "span",
        {class: unit ? "number-box with-unit" : "number-box"},
        input,
        unit ? el("span", {class: "unit", "aria-hidden": "true"}, unit) : null,
    );
    const word = key.word === undefined ? null : wordSwitch(key, input, edit);
    const dice = key.name === "seed" ? diceFor(key, edit) : null;
    listenToText(key, input, (text, how) => {
        slider?.show(Number(text));
        edit(text, how);
    });
    return {
        element: el(
            "div",
            {class: slider ? "field-number" : "field-number no-slider"},
            slider?.element,
            word?.element,
            box,
            dice,
        ),
        control: input,
        show(value, text) {
            const isWord = key.word !== undefined && value === key.word;
            input.value =
                text !== undefined && typeof value !== "string" ? formatText(text) : String(formatValue(value));
            input.dataset.shown = input.value;
            slider?.show(isWord ? scale.min : value);
            word?.show(isWord);
        },
        busy: () =>
            slider?.gesture.held === true || (document.activeElement === input && input.value !== input.dataset.shown),
    };
}

const formatValue = (value) => (typeof value === "number" ? formatNumber(value) : (value ?? ""));
const formatText = (text) => text.replace(/^"(.*)"$/, "$1");

function sliderFor(key, scale, input, edit, label) {
    const gesture = new Gesture();
    const element = el("input", {
        type: "range",
        min: scale.min,
        max: scale.max,
        step: scale.step,
        tabindex: "0",
        "aria-label": `${label}, slider`,
        data: {slider: key.path},
    });
    const value = () => scale.value(Number(element.value));
    const fill = () => {
        const range = Number(element.max) - Number(element.min);
        element.style.setProperty("--fill", `${(100 * (Number(element.value) - Number(element.min))) / range}%`);
        element.setAttribute("aria-valuetext", input.value);
    };
    const send = (live) => {
        input.value = formatNumber(value());
        fill();
        edit(formatNumber(value(), 12), {gesture: gesture.current, live});
    };
    element.addEventListener("pointerdown", () => {
        gesture.start();
        gesture.held = true;
    });
    for (const end of ["pointerup", "pointercancel", "change"]) {
        element.addEventListener(end, () => {
            gesture.held = false;
        });
    }
    element.addEventListener("input", () => send(true));
    element.addEventListener("change", () => send(false));
    const show = (number) => {
        element.value = typeof number === "number" ? clamp(scale.position(number), scale.min, scale.max) : scale.min;
        fill();
    };
    return {element, show, gesture};
}

function listenToText(key, input, edit) {
    const gesture = new Gesture();
    input.addEventListener("focus", () => {
        input.dataset.shown = input.value;
        input.select();
    });
    input.addEventListener("change", () => {
        input.dataset.shown = input.value;
        edit(textToToml(input.value), {});
    });
    input.addEventListener("keydown", (event) => {
        const direction = {ArrowUp: 1, ArrowDown: -1}[event.key];
        const number = Number(input.value);
        if (!direction || !Number.isFinite(number)) {
            return;
        }
        event.preventDefault();
        const step = stepOf(key, number) * (event.shiftKey ? 10 : 1);
        input.value = formatNumber(clamp(number + direction * step, key.min, key.max));
        input.dataset.shown = input.value;
        edit(input.value, {gesture: gesture.current, live: false});
    });
}

// A switch for the word that the key takes instead of a number.
function wordSwitch(key, input, edit) {
    const name = key.word === 0 ? "off" : String(key.word);
    const element = el(
        "button",
        {
            type: "button",
            class: "word",
            "aria-pressed": "false",
            "aria-label": `${key.name.replaceAll("_", " ")}: ${name}`,
        },
        name,
    );
    element.addEventListener("click", () => {
        const on = element.getAttribute("aria-pressed") === "true";
        edit(on ? String(Math.max(key.min, 1)) : toToml(key.word), {});
    });
    return {element, show: (on) => element.setAttribute("aria-pressed", String(on))};
}

function diceFor(key, edit) {
    return iconButton("dice", `Roll the dice for ${key.path}`, () => edit(String(randomSeed()), {}), {
        data: {dice: key.path},
    });
}

/** Returns a random seed. */
export const randomSeed = () => Math.floor(Math.random() * kRandomSeeds);
