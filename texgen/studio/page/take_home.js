// SPDX-License-Identifier: Apache-2.0

// The menu "Take home": the command, the preset file, and pictures as files.

import {$} from "./dom.js";
import {ApiError, download, post} from "./api.js";

export class TakeHome {
    #studio;
    #actions;

    constructor(studio) {
        this.#studio = studio;
        this.#actions = {
            "copy-command": () => this.copyCommand(),
            "save-preset": () => this.askName(),
            "download-preset": () => this.download("preset"),
            "download-frame": () => this.download("frame"),
            "download-drawing": () => this.download("drawing"),
            "download-loop": () => this.download("loop"),
            "download-loop-preview": () => this.download("loop", studio.painter.width),
        };
        for (const [id, action] of Object.entries(this.#actions)) {
            $(id).addEventListener("click", () => {
                $("take-home-menu").hidePopover();
                action();
            });
        }
        $("take-home-menu").addEventListener("beforetoggle", (event) => event.newState === "open" && this.#prepare());
        $("take-home-menu").addEventListener("toggle", (event) => this.#onToggle(event));
        $("take-home-menu").addEventListener("keydown", (event) => this.#onKey(event));
        $("save-form").addEventListener("submit", (event) => this.#save(event));
        $("save-cancel").addEventListener("click", () => $("save-dialog").close());
    }

    /** Copies the command that bakes the same images. */
    async copyCommand() {
        const command = this.#studio.answer?.command;
        if (!command) {
            this.#studio.status.say(
                "The events are changed: the command needs a preset file. Save the preset, then bake the file.",
            );
            return;
        }
        try {
            await navigator.clipboard.writeText(command);
            this.#studio.status.say(`Copied: ${command}`);
        } catch {
            this.#studio.status.say("The browser did not allow copying. The command is in the dialog “Bake”.");
        }
    }

    /** Asks for the name of the preset file. */
    askName() {
        const {preset} = this.#studio.state;
        $("save-name").value = preset.endsWith(".toml") ? preset : `my_${preset}.toml`;
        $("save-overwrite").checked = preset.endsWith(".toml");
        $("save-error").hidden = true;
        $("save-folder").textContent = this.#studio.program.folder;
        $("save-dialog").showModal();
        $("save-name").select();
    }

    /**
     * Downloads the preset, the frame as a picture or a drawing, or the loop. `width` is the largest width and height
     * of the loop in pixels; null stands for the size of the preset.
     */
    async download(kind, width = null) {
        const {state, player, map, status} = this.#studio;
        const name = state.preset.replace(/\.toml$/, "");
        const fallback = {
            preset: `${name}.toml`,
            frame: `${name}_${map}_${player.frame}.png`,
            drawing: `${name}_${player.frame}.svg`,
            loop: `${name}_${map}.png`,
        }[kind];
        status.say(kind === "loop" ? "The loop is being written." : "The file is being written.");
        try {
            const file = await download({settings: state.settings(), kind, frame: player.frame, map, width}, fallback);
            status.say(`Downloaded ${file}.`);
        } catch (error) {
            status.say(error.message);
        }
    }

    #prepare() {
        const {answer, baked, player} = this.#studio;
        $("copy-command").disabled = Boolean(baked) || !answer?.command;
        $("copy-command").title = answer?.command ?? "The events are changed: the command needs a preset file.";
        for (const id of ["save-preset", "download-preset", "download-frame", "download-drawing"]) {
            $(id).disabled = Boolean(baked);
        }
        for (const id of ["download-loop", "download-loop-preview"]) {
            $(id).disabled = Boolean(baked) || player.count < 2;
        }
        $("loop-size").textContent = (answer?.size ?? []).join(" × ");
        $("loop-preview-size").textContent = `${this.#studio.painter.width} pixels wide`;
    }

    #onToggle(event) {
        $("take-home").setAttribute("aria-expanded", String(event.newState === "open"));
        if (event.newState === "open") {
            const box = $("take-home").getBoundingClientRect();
            $("take-home-menu").style.top = `${box.bottom + 4}px`;
            $("take-home-menu").style.right = `${innerWidth - box.right}px`;
            $("take-home-menu").querySelector("button:not(:disabled)")?.focus();
        }
    }

    #onKey(event) {
        const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
        if (!step) {
            return;
        }
        event.preventDefault();
        const items = [...$("take-home-menu").querySelectorAll("button:not(:disabled)")];
        const index = items.indexOf(document.activeElement);
        items[(index + step + items.length) % items.length].focus();
    }

    async #save(event) {
        event.preventDefault();
        const name = $("save-name").value.trim();
        const file = name.endsWith(".toml") ? name : `${name}.toml`;
        try {
            const answer = await post("/api/save", {
                settings: this.#studio.state.settings(),
                file,
                overwrite: $("save-overwrite").checked,
            });
            $("save-dialog").close();
            this.#studio.status.say(`Saved ${answer.file}.`);
            await this.#studio.gallery.refreshFolder();
        } catch (error) {
            if (!(error instanceof ApiError)) {
                throw error;
            }
            $("save-error").hidden = false;
            $("save-error").textContent = error.message;
        }
    }
}
