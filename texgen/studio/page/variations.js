// SPDX-License-Identifier: Apache-2.0

// A sheet of small pictures of the preset, which differ in the value of one key, such as the seed. A click on a picture
// sets the key to the value of this picture.

import {$, debounce, el} from "./dom.js";
import {ApiError, postPicture} from "./api.js";
import {changesFoam} from "./state.js";
import {formatNumber, scaleOf} from "./scale.js";
import {randomSeed} from "./field_number.js";
import {tablesOf} from "./schema.js";
import {toToml} from "./toml.js";

const kWidth = 256; // largest width and height of a picture in pixels
const kGap = 12; // CSS pixels between pictures, as in tools.css
const kCaption = 28; // height of the text below a picture in CSS pixels
const kMinSide = 96; // smallest side of a picture in CSS pixels
const kEdit = 250; // milliseconds from the last edit until the sheet is drawn again
const kLinearScale = {position: (value) => value, value: (position) => position}; // a linear scale for any range

export class Variations {
    #studio;
    #keys;
    #abort = null;
    #stale = true;

    constructor(studio) {
        this.#studio = studio;
        this.#keys = tablesOf(studio.program.schema)
            .flatMap((table) => table.keys)
            .filter((key) => ["number", "choice", "color"].includes(key.kind) && key.table !== "output");
        this.#fillMenu();
        for (const id of ["vary-from", "vary-to", "vary-count"]) {
            $(id).addEventListener("change", () => this.#draw());
        }
        $("vary-key").addEventListener("change", () => this.#onKey());
        $("vary-again").addEventListener("click", () => this.#draw());
        const drawSoon = debounce(kEdit, () => this.#draw());
        studio.refreshed.on(() => {
            this.#stale = true;
            if (this.#open) {
                drawSoon();
            }
        });
        studio.ui.on("mode", () => (this.#open ? this.#stale && this.#draw() : this.#abort?.abort()));
        new ResizeObserver(() => this.#arrange()).observe($("sheet"));
        this.#onKey(false);
    }

    /** Shows the sheet with values of a key. */
    show(path) {
        if (this.#keys.some((key) => key.path === path)) {
            $("vary-key").value = path;
            this.#onKey(false);
            this.#stale = true;
        }
        this.#studio.ui.set("mode", "variations");
    }

    get #open() {
        return this.#studio.ui.get("mode") === "variations";
    }

    get #key() {
        return this.#keys.find((key) => key.path === $("vary-key").value);
    }

    #fillMenu() {
        const tables = [...new Set(this.#keys.map((key) => key.table))];
        $("vary-key").replaceChildren(
            ...tables.map((table) =>
                el(
                    "optgroup",
                    {label: table},
                    ...this.#keys
                        .filter((key) => key.table === table)
                        .map((key) => el("option", {value: key.path}, key.path)),
                ),
            ),
        );
        $("vary-key").value = "foam.seed";
    }

    // Shows the fields for the chosen key. For a number, sets the range of its values: from half of
    // the present value to twice this value. If the key allows only a narrow range, or if the
    // present value is not positive, sets the whole range of the key.
    #onKey(draw = true) {
        const key = this.#key;
        const ranged = key.kind === "number" && key.name !== "seed";
        $("vary-range").hidden = !ranged;
        $("vary-again").hidden = key.name !== "seed" && key.kind !== "color";
        $("vary-help").textContent = key.help;
        if (ranged) {
            const value = this.#studio.answer?.values[key.path];
            const wide = key.max - key.min > 20 && typeof value === "number" && value > 0;
            $("vary-from").value = formatNumber(wide ? Math.max(key.min, value / 2) : key.min, 3);
            $("vary-to").value = formatNumber(wide ? Math.min(key.max, value * 2) : key.max, 3);
        }
        if (draw) {
            this.#draw();
        }
    }

    #values() {
        const key = this.#key;
        const count = Number($("vary-count").value);
        if (key.kind === "choice") {
            return key.choices.map(toToml);
        }
        if (key.kind === "color") {
            return Array.from({length: count}, () => toToml(randomColor()));
        }
        return key.name === "seed" ? this.#seeds(count) : this.#numbers(key, count);
    }

    #seeds(count) {
        const current =
            this.#studio.state.change(this.#key.path) ?? String(this.#studio.answer?.values[this.#key.path] ?? 1);
        return [current, ...Array.from({length: count - 1}, () => String(randomSeed()))];
    }

    // Returns numbers that are evenly spaced on a slider for the range. If the range is empty or too
    // wide for a slider, the numbers themselves are evenly spaced.
    #numbers(key, count) {
        const [from, to] = [Number($("vary-from").value), Number($("vary-to").value)];
        const range = {...key, min: Math.min(from, to), max: Math.max(from, to)};
        const scale = (range.min < range.max && scaleOf(range)) || kLinearScale;
        const position = (index) =>
            scale.position(from) + ((scale.position(to) - scale.position(from)) * index) / (count - 1);
        const values = Array.from({length: count}, (_, index) => scale.value(position(index)));
        return [...new Set(values.map((value) => formatNumber(key.integer ? Math.round(value) : value, 4)))];
    }

    async #draw() {
        this.#abort?.abort();
        if (!this.#open || this.#studio.baked) {
            return;
        }
        const abort = new AbortController();
        this.#abort = abort;
        this.#stale = false;
        const key = this.#key;
        const cells = this.#values().map((text) => this.#cell(key, text));
        $("sheet").replaceChildren(...cells.map((cell) => cell.element));
        this.#arrange();
        for (const cell of cells) {
            await this.#drawCell(key, cell, abort.signal);
            if (abort.signal.aborted) {
                return;
            }
        }
    }

    // Chooses the number of columns that gives the largest pictures without scrolling.
    #arrange() {
        const count = $("sheet").childElementCount;
        const [width, height] = [$("sheet").clientWidth - 2 * kGap, $("sheet").clientHeight - 2 * kGap];
        const sideFor = (columns) => {
            const rows = Math.ceil(count / columns);
            return Math.min((width - kGap * (columns - 1)) / columns, (height - kGap * (rows - 1)) / rows - kCaption);
        };
        const sides = Array.from({length: count}, (_, index) => sideFor(index + 1));
        const side = Math.max(kMinSide, ...sides);
        const columns = side > kMinSide ? sides.indexOf(side) + 1 : "auto-fill";
        $("sheet").style.gridTemplateColumns = `repeat(${columns}, ${Math.floor(side)}px)`;
    }

    #cell(key, text) {
        const canvas = el("canvas", {width: kWidth, height: kWidth, "aria-hidden": "true"});
        const name = text.replaceAll('"', "");
        const caption = el("span", {class: "cell-name"}, name);
        const element = el(
            "button",
            {
                type: "button",
                class: "cell",
                "aria-label": `Keep ${key.path} = ${name}`,
                data: {value: text},
                onclick: () => this.#keep(key, text),
            },
            canvas,
            caption,
        );
        const value = this.#studio.answer?.values[key.path];
        element.toggleAttribute("aria-current", toToml(value ?? "") === text || String(value) === text);
        return {element, canvas, caption, text};
    }

    // A picture with another foam than the edited preset is drawn as a draft, because a full picture would stop the
    // simulation of the edited preset.
    async #drawCell(key, cell, signal) {
        const {state, map, player} = this.#studio;
        const foam = changesFoam(key.path) || !this.#studio.painter.showsFrame;
        const body = {
            settings: state.settings([[key.path, cell.text]]),
            frame: foam ? 1 : player.frame,
            map,
            width: kWidth,
            quality: foam ? "draft" : "full",
            samples: "rgba",
        };
        try {
            const picture = await postPicture("/api/picture", body, signal);
            cell.canvas.width = picture.width;
            cell.canvas.height = picture.height;
            cell.canvas.getContext("2d").putImageData(picture.pixels, 0, 0);
            cell.element.classList.add("drawn");
        } catch (error) {
            if (error instanceof ApiError) {
                cell.element.classList.add("failed");
                cell.element.title = error.message;
                cell.caption.textContent += ": not allowed";
            }
        }
    }

    #keep(key, text) {
        this.#studio.state.set(key.path, text);
        this.#studio.status.say(`${key.path} is now ${text}.`);
        this.#studio.ui.set("mode", "picture");
    }
}

function randomColor() {
    return `#${Math.floor(Math.random() * 0x1000000)
        .toString(16)
        .padStart(6, "0")}`;
}
