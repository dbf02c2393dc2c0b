// SPDX-License-Identifier: Apache-2.0

// Shows the value that the map has under the pointer, and facts about the bubble there.

import {$, el} from "./dom.js";
import {ApiError} from "./api.js";
import {formatNumber} from "./scale.js";
import {Lane} from "./lane.js";

const kPatience = 2000; // milliseconds after which a newer request cancels a running one

export class Readout {
    #studio;
    #lane = new Lane(kPatience);
    #point = null;
    #pinned = false;

    constructor(studio) {
        this.#studio = studio;
        studio.view.gestures.hovered.on((point) => !this.#pinned && this.#pick(point));
        studio.view.gestures.clicked.on((point) => this.#click(point));
        studio.painter.painted.on(() => this.#pick(this.#point));
        studio.refreshed.on(() => this.#showLegend());
        studio.painter.painted.on((picture) => this.#showLegend(picture));
        $("readout-copy").addEventListener("click", () =>
            navigator.clipboard?.writeText($("readout-copy").dataset.text),
        );
        $("readout-unpin").addEventListener("click", () => this.#unpin());
    }

    /** True while another part of the page waits for a click in the picture. */
    suspended = false;

    // A click keeps the readout at a point, until the button in the readout is pressed (#unpin).
    #click(point) {
        if (this.suspended) {
            return;
        }
        this.#pinned = true;
        this.#pick(point);
        this.#showPin();
    }

    #unpin() {
        this.#pinned = false;
        this.#pick(null);
        this.#showPin();
    }

    #showPin() {
        $("readout-unpin").hidden = !this.#pinned;
        $("readout").classList.toggle("pinned", this.#pinned);
    }

    #pick(point) {
        this.#point = point;
        const picture = this.#studio.view.picture;
        if (!point || !picture) {
            $("readout").hidden = true;
            return;
        }
        const x = Math.min(picture.width - 1, Math.floor(point[0] * picture.width));
        const y = Math.min(picture.height - 1, Math.floor(point[1] * picture.height));
        if (picture.draft) {
            this.#show(x, y, {numbers: [], unit: "", color: colorAt(picture, x, y), bubble: null});
        } else if (!this.#studio.player.playing) {
            this.#ask(picture, x, y);
        } else {
            $("readout").hidden = true;
        }
    }

    #ask(picture, x, y) {
        const {source} = this.#studio.painter;
        this.#lane.run(async (signal) => {
            try {
                const value = await source.pick(picture, x, y, signal);
                if (this.#point) {
                    this.#show(x, y, value);
                }
            } catch (error) {
                if (!(error instanceof ApiError)) {
                    throw error;
                }
                $("readout").hidden = true;
            }
        });
    }

    #show(x, y, {numbers, unit, color, bubble}) {
        $("readout").hidden = false;
        $("readout-position").textContent = `${x}, ${y}`;
        $("readout-swatch").hidden = !color;
        $("readout-swatch").style.backgroundColor = color ?? "";
        const text = color ?? numbers.map((number) => formatNumber(number, 4)).join("  ");
        $("readout-value").textContent = text;
        $("readout-unit").textContent = color ? "" : shortUnit(unit);
        $("readout-copy").dataset.text = text;
        $("readout-bubble").replaceChildren(...(bubble ? factsOf(bubble) : []));
    }

    // Shows the numbers that black and white stand for, if the map has numbers and `picture` gives its range.
    #showLegend(picture = null) {
        const map = this.#studio.program.maps.find((one) => one.name === this.#studio.map);
        const known = picture && picture.low !== null && picture.low !== undefined && map?.kind === "number";
        $("legend").hidden = !known;
        if (known) {
            $("legend-low").textContent = formatNumber(picture.low, 4);
            $("legend-high").textContent = formatNumber(picture.high, 4);
            $("legend-unit").textContent = shortUnit(map.unit);
        }
    }
}

// Returns the unit of a map without the part that tells how PNG files store the numbers.
const shortUnit = (unit) => unit.split(/;|PNG:/)[0].trim();

function factsOf(bubble) {
    const facts = {
        bubble: bubble.id,
        area: formatNumber(bubble.area, 4),
        sides: bubble.sides,
        pressure: formatNumber(bubble.pressure, 4),
    };
    return Object.entries(facts).flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, String(value))]);
}

function colorAt(picture, x, y) {
    const at = 4 * (y * picture.width + x);
    const hex = (value) => value.toString(16).padStart(2, "0");
    return `#${[...picture.pixels.data.subarray(at, at + 3)].map(hex).join("")}`;
}
