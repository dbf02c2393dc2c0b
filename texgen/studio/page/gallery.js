// SPDX-License-Identifier: Apache-2.0

// The gallery: the shipped presets with their pictures, the preset files in the folder of the studio, and the baked
// sets in this folder and its subfolders.

import {$, debounce, el, icon} from "./dom.js";
import {getProgram, post} from "./api.js";
import {Thumbnails} from "./thumbnails.js";

export class Gallery {
    #studio;
    #thumbnails;

    constructor(studio) {
        this.#studio = studio;
        this.#thumbnails = new Thumbnails(studio, $("gallery"));
        $("gallery-toggle").addEventListener("click", () => this.toggle());
        $("gallery-search").addEventListener("input", () => this.#filter());
        $("gallery-search").addEventListener("keydown", (event) => this.#openFirst(event));
        $("bakes-refresh").addEventListener("click", () => this.refreshFolder());
        studio.ui.on("gallery", () => this.#showOpen());
        studio.state.changed.on(() => this.#showCurrent());
        studio.refreshed.on(() => this.#showCurrent());
        studio.painter.painted.on(debounce(300, () => this.#thumbnails.start()));
        $("gallery-presets").replaceChildren(...studio.program.presets.map((preset) => this.#card(preset)));
        this.#showFiles(studio.program.files);
        this.#showOpen();
        this.#showCurrent();
        this.refreshBakes();
    }

    toggle() {
        this.#studio.ui.set("gallery", !this.#studio.ui.get("gallery"));
    }

    /** Lists the files and the baked sets of the folder again. */
    async refreshFolder() {
        const program = await getProgram();
        this.#studio.program.files = program.files;
        this.#showFiles(program.files);
        await this.refreshBakes();
        this.#showCurrent();
    }

    /** Lists the baked sets of the folder again. */
    async refreshBakes() {
        const {bakes} = await post("/api/bakes", {});
        $("gallery-bakes").replaceChildren(...bakes.map((bake) => this.#bakeEntry(bake)));
        $("bakes-none").hidden = bakes.length > 0;
    }

    #card(preset) {
        const canvas = el("canvas", {width: 160, height: 160, class: "thumbnail", "aria-hidden": "true"});
        const card = el(
            "button",
            {
                type: "button",
                class: "card",
                title: preset.description,
                data: {preset: preset.name},
                "aria-label": `${preset.name}: ${preset.description}`,
                onclick: () => this.#studio.open(preset.name),
            },
            canvas,
            el("span", {class: "card-name"}, preset.name.replaceAll("_", " ")),
        );
        this.#thumbnails.add(card, canvas, preset);
        return el("li", {}, card);
    }

    #showFiles(files) {
        $("gallery-files").replaceChildren(
            ...files.map((file) =>
                el(
                    "li",
                    {},
                    el(
                        "button",
                        {type: "button", class: "entry", data: {preset: file}, onclick: () => this.#studio.open(file)},
                        icon("file"),
                        el("span", {}, file),
                    ),
                ),
            ),
        );
        $("files-none").hidden = files.length > 0;
    }

    #bakeEntry(bake) {
        const maps = bake.maps.map((map) => map.name).join(", ");
        const text = `${bake.frames.length} frames, ${bake.size.join(" × ")}, ${maps}`;
        return el(
            "li",
            {},
            el(
                "button",
                {
                    type: "button",
                    class: "entry two-lines",
                    title: text,
                    data: {bake: `${bake.folder}/${bake.preset}`, set: bake.set},
                    onclick: () => this.#studio.openBaked(bake),
                },
                icon("film"),
                el("span", {}, `${bake.folder || "."} · ${bake.preset}`, el("small", {}, text)),
            ),
        );
    }

    #filter() {
        const word = $("gallery-search").value.trim().toLowerCase();
        for (const card of $("gallery-presets").querySelectorAll(".card")) {
            card.parentElement.hidden = !card
                .getAttribute("aria-label")
                .toLowerCase()
                .replaceAll("_", " ")
                .includes(word);
        }
    }

    #openFirst(event) {
        if (event.key === "Enter") {
            $("gallery-presets").querySelector("li:not([hidden]) .card")?.click();
        }
    }

    #showOpen() {
        const open = this.#studio.ui.get("gallery");
        $("gallery").hidden = !open;
        document.body.classList.toggle("gallery-closed", !open);
        $("gallery-toggle").setAttribute("aria-expanded", String(open));
    }

    #showCurrent() {
        const {baked, state} = this.#studio;
        for (const button of $("gallery").querySelectorAll("[data-preset], [data-bake]")) {
            const current = baked
                ? button.dataset.bake === `${baked.folder}/${baked.preset}` && button.dataset.set === baked.set
                : button.dataset.preset === state.preset;
            button.toggleAttribute("aria-current", current);
        }
    }
}
