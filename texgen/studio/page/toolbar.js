// SPDX-License-Identifier: Apache-2.0

// The bars above the picture: name and undo; tabs, map, tiling, zoom and the width of pictures.

import {$, el} from "./dom.js";

const kModes = ["picture", "lit", "variations"];
const kZoomStep = Math.SQRT2;

export class Toolbar {
    #studio;

    constructor(studio) {
        this.#studio = studio;
        const {state, ui, view} = studio;
        $("undo").addEventListener("click", () => state.undo());
        $("redo").addEventListener("click", () => state.redo());
        $("map").addEventListener("change", () => ui.set("map", $("map").value));
        $("width").addEventListener("change", () => ui.set("width", Number($("width").value)));
        $("tiling").addEventListener("change", (event) => ui.set("tiling", Number(event.target.value)));
        $("zoom-in").addEventListener("click", () => view.zoomBy(kZoomStep));
        $("zoom-out").addEventListener("click", () => view.zoomBy(1 / kZoomStep));
        $("zoom-fit").addEventListener("click", () => view.fit());
        $("zoom-pixels").addEventListener("click", () => view.setZoom(1 / devicePixelRatio));
        $("baked-close").addEventListener("click", () => studio.closeBaked());
        ui.on("tiling", () => this.#showTiling());
        ui.on("mode", () => this.#showMode());
        view.moved.on(() => this.#showZoom());
        state.changed.on(() => this.#showDocument());
        studio.refreshed.on(() => this.#showDocument());
        studio.answered.on(() => this.#showDocument());
        this.#listenToTabs();
        $("width").value = String(ui.get("width"));
        this.#showTiling();
        this.#showMode();
        this.#showDocument();
        this.#showZoom();
    }

    /** Shows the next map of the list if `step` is 1, the previous map if it is -1. */
    stepMap(step) {
        const options = [...$("map").options];
        const index = options.findIndex((option) => option.value === this.#studio.map);
        this.#studio.ui.set("map", options[(index + step + options.length) % options.length].value);
    }

    // The tabs follow the pattern of the ARIA Authoring Practices: arrow keys move between them.
    #listenToTabs() {
        for (const [index, mode] of kModes.entries()) {
            const tab = $(`tab-${mode}`);
            tab.addEventListener("click", () => this.#studio.ui.set("mode", mode));
            tab.addEventListener("keydown", (event) => {
                const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
                if (step) {
                    event.preventDefault();
                    event.stopPropagation();
                    const next = kModes[(index + step + kModes.length) % kModes.length];
                    this.#studio.ui.set("mode", next);
                    $(`tab-${next}`).focus();
                }
            });
        }
    }

    #showMode() {
        const current = this.#studio.ui.get("mode");
        for (const mode of kModes) {
            $(`tab-${mode}`).setAttribute("aria-selected", String(mode === current));
            $(`tab-${mode}`).tabIndex = mode === current ? 0 : -1;
            $(`panel-${mode}`).hidden = mode !== current;
        }
        document.body.dataset.mode = current;
    }

    #showTiling() {
        const tiles = this.#studio.answer?.tiles ?? true;
        const tiling = tiles ? this.#studio.ui.get("tiling") : 1;
        for (const radio of $("tiling").querySelectorAll("input")) {
            radio.checked = Number(radio.value) === tiling;
            radio.disabled = !tiles && radio.value !== "1";
        }
        if (tiling !== this.#studio.view.tiling) {
            this.#studio.view.setTiling(tiling);
        }
    }

    #showZoom() {
        const percent = 100 * this.#studio.view.deviceZoom;
        $("zoom-pixels").textContent = `${percent < 10 ? percent.toFixed(1) : Math.round(percent)} %`;
    }

    #showDocument() {
        const {state, answer, baked} = this.#studio;
        const changes = state.changes.length + (state.events === null ? 0 : 1);
        $("document-name").textContent = baked ? baked.folder || baked.preset : state.preset;
        $("document-changes").textContent = changes === 0 || baked ? "" : `${changes} changed`;
        $("description").textContent = answer?.description ?? "";
        $("picture").setAttribute(
            "aria-label",
            `Picture of ${$("document-name").textContent}, map ${this.#studio.map}`,
        );
        $("undo").disabled = !state.canUndo;
        $("redo").disabled = !state.canRedo;
        document.title = `${state.preset}${changes > 0 ? " •" : ""} – foamtex studio`;
        this.#showTiling();
        this.#showSource();
    }

    // Lists the maps of the preset first, then all others.
    #showSource() {
        const {program, answer, baked, map} = this.#studio;
        const own = baked ? baked.maps.map((one) => one.name) : (answer?.maps ?? []);
        const others = baked ? [] : program.maps.map((one) => one.name).filter((name) => !own.includes(name));
        const list = [...own, "|", ...others].join();
        if ($("map").dataset.list !== list) {
            $("map").dataset.list = list;
            $("map").replaceChildren(
                this.#group(baked ? "Baked maps" : "Maps of the preset", own),
                ...(others.length > 0 ? [this.#group("All other maps", others)] : []),
            );
        }
        $("map").value = map;
        $("map").title = program.maps.find((one) => one.name === map)?.meaning ?? map;
        $("baked-bar").hidden = !baked;
        if (baked) {
            $("baked-name").textContent =
                `${baked.folder}: ${baked.preset}, ${baked.size.join(" × ")}, ${baked.frames.length} frames`;
        }
    }

    #group(label, names) {
        const meaning = (name) => this.#studio.program.maps.find((one) => one.name === name)?.meaning ?? "";
        return el("optgroup", {label}, ...names.map((name) => el("option", {value: name, title: meaning(name)}, name)));
    }
}
