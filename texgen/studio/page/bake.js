// SPDX-License-Identifier: Apache-2.0

// The dialog in which the user chooses what to bake and in which folder, and sees the progress of the bake.

import {$, el} from "./dom.js";
import {ApiError, post} from "./api.js";

const kPoll = 400; // milliseconds between two requests for the progress

export class BakeDialog {
    #studio;
    #bake = null;
    #status = null; // the last known progress of the bake
    #mapsChosen = false;

    constructor(studio) {
        this.#studio = studio;
        $("bake-open").addEventListener("click", () => this.open());
        $("bake-chip").addEventListener("click", () => this.open());
        $("bake-close").addEventListener("click", () => $("bake-dialog").close());
        $("bake-form").addEventListener("submit", (event) => this.#start(event));
        $("bake-cancel").addEventListener("click", () => this.#cancel());
        $("bake-again").addEventListener("click", () => this.#showForm());
        $("bake-all-frames").addEventListener("change", () => this.#showRange());
        $("bake-profile").addEventListener("change", () => this.#showProfile());
        $("bake-maps").addEventListener("change", () => {
            this.#mapsChosen = true;
        });
        $("bake-sizes").addEventListener("click", (event) => this.#chooseSize(event.target.dataset.size));
        $("bake-open-folder").addEventListener("click", () => this.#openFolder());
        this.#fill();
    }

    /** Opens the dialog with the progress of the running bake, or with the form if no bake runs. */
    open() {
        if (!this.#studio.answer) {
            return;
        }
        if (this.#bake === null) {
            this.#showForm();
        }
        $("bake-dialog").showModal();
    }

    #fill() {
        const {program} = this.#studio;
        $("bake-root").textContent = `${program.folder}/`;
        $("bake-profile").append(
            ...program.profiles.map((profile) =>
                el("option", {value: profile.name}, profile.description.split(":")[0]),
            ),
        );
        $("bake-maps").replaceChildren(
            ...program.maps.map((map) =>
                el(
                    "label",
                    {title: map.meaning},
                    el("input", {type: "checkbox", value: map.name}),
                    el("span", {}, map.name),
                ),
            ),
        );
    }

    #showForm() {
        const {answer, state} = this.#studio;
        $("bake-form").hidden = false;
        $("bake-progress").hidden = true;
        $("bake-error").hidden = true;
        if ($("bake-folder").dataset.preset !== state.preset) {
            $("bake-folder").dataset.preset = state.preset;
            $("bake-folder").value = `${state.preset.replace(/\.toml$/, "")}_out`;
            this.#mapsChosen = false;
        }
        if (!this.#mapsChosen) {
            this.#checkMaps(answer.maps);
        }
        $("bake-width").value = answer.size[0];
        $("bake-height").value = answer.size[1];
        $("bake-count").textContent = `${answer.frames} frames`;
        $("bake-range").placeholder = `1-${answer.frames}`;
        $("bake-command").textContent =
            answer.command ?? "None: the events have been changed, so the command would need a preset file.";
        this.#showRange();
        this.#showProfile();
    }

    #checkMaps(names) {
        for (const box of $("bake-maps").querySelectorAll("input")) {
            box.checked = names.includes(box.value);
        }
    }

    #showRange() {
        $("bake-range").disabled = $("bake-all-frames").checked;
    }

    // A profile chooses maps, packing, format and file names for an engine.
    #showProfile() {
        const profile = this.#studio.program.profiles.find((one) => one.name === $("bake-profile").value);
        $("bake-profile-text").textContent = profile?.description ?? "Files for any program.";
        $("bake-profile-maps").hidden = !profile;
        $("bake-map-choice").disabled = Boolean(profile);
        $("bake-format").disabled = Boolean(profile);
    }

    #chooseSize(side) {
        if (side) {
            const [width, height] = this.#studio.answer.size;
            $("bake-width").value = side;
            $("bake-height").value = Math.round((side * height) / width);
        }
    }

    #request() {
        const chosen = [...$("bake-maps").querySelectorAll("input:checked")].map((box) => box.value);
        return {
            settings: this.#studio.state.settings(),
            folder: $("bake-folder").value.trim(),
            frames: $("bake-all-frames").checked ? null : $("bake-range").value.trim() || null,
            format: $("bake-format").querySelector("input:checked").value,
            profile: $("bake-profile").value || null,
            maps: chosen,
            size: [Number($("bake-width").value), Number($("bake-height").value)],
            resume: $("bake-resume").checked,
        };
    }

    async #start(event) {
        event.preventDefault();
        $("bake-error").hidden = true;
        try {
            const {bake, command} = await post("/api/bake", this.#request());
            this.#bake = bake;
            $("bake-progress-command").textContent = command;
            $("bake-form").hidden = true;
            $("bake-progress").hidden = false;
            this.#showStatus({
                status: "running",
                phase: "",
                done: 0,
                total: 0,
                seconds: 0,
                seconds_left: null,
                files: 0,
            });
            $("bake-cancel").focus();
            this.#poll(bake);
        } catch (error) {
            this.#showError(error);
        }
    }

    #showError(error) {
        if (!(error instanceof ApiError)) {
            throw error;
        }
        $("bake-error").hidden = false;
        $("bake-error").textContent = error.message;
    }

    async #poll(bake) {
        try {
            const status = await post("/api/bake/status", {bake});
            this.#showStatus(status);
            if (status.status !== "running") {
                this.#finish(status);
                return;
            }
        } catch (error) {
            // The server no longer knows the bake (422), or no longer admits the page (403).
            if (error instanceof ApiError && (error.status === 422 || error.status === 403)) {
                const message = "The program was started again, or another page has begun a bake.";
                const status = {...this.#status, status: "failed", message};
                this.#showStatus(status);
                this.#finish(status);
                return;
            }
        }
        setTimeout(() => this.#poll(bake), kPoll);
    }

    async #cancel() {
        await post("/api/bake/cancel", {bake: this.#bake}).catch(() => {});
    }

    #finish({status, message}) {
        this.#bake = null;
        $("bake-chip").hidden = true;
        const texts = {
            complete: "The bake is complete.",
            canceled: "The bake was canceled.",
            failed: `The bake failed. ${message ?? ""}`,
        };
        this.#studio.status.say(texts[status]);
        this.#studio.gallery.refreshBakes();
    }

    #showStatus(progress) {
        this.#status = progress;
        const {status, phase, done, total, seconds, seconds_left, files, first_file, message} = progress;
        const running = status === "running";
        const part = total > 0 ? done / total : running ? 0 : 1;
        const titles = {running: "Baking", complete: "Complete", failed: "Failed", canceled: "Canceled"};
        $("bake-status").textContent = running && phase ? `Baking: ${phase}` : titles[status];
        $("bake-bar").value = status === "complete" ? 1 : part;
        $("bake-numbers").textContent = total > 0 && running ? `${done} of ${total}` : "";
        $("bake-time").textContent = running ? timeLeft(seconds, seconds_left) : `${seconds.toFixed(1)} s`;
        $("bake-files").textContent = files > 0 ? `${files} files, the first is ${first_file}` : "";
        $("bake-message").hidden = !message;
        $("bake-message").textContent = message ?? "";
        $("bake-cancel").hidden = !running;
        $("bake-again").hidden = running;
        $("bake-open-folder").hidden = status !== "complete";
        $("bake-dialog").dataset.status = status;
        $("bake-chip").hidden = !running;
        $("bake-chip").textContent = `Baking ${Math.round(100 * part)} %`;
    }

    // Shows the images of the bake (a baked set) in the view. This set is the newest one of its folder, and thus the
    // last of the folder's sets in the answer to /api/bakes.
    async #openFolder() {
        const folder = $("bake-folder").value.trim().replace(/\/+$/, "");
        const {bakes} = await post("/api/bakes", {});
        const found =
            bakes.find((one) => one.folder === folder) ?? bakes.find((one) => one.folder.startsWith(`${folder}/`));
        const bake = bakes.findLast((one) => one.folder === found?.folder);
        if (bake) {
            $("bake-dialog").close();
            this.#studio.openBaked(bake);
        }
    }
}

function timeLeft(seconds, left) {
    const text = (value) => (value < 90 ? `${Math.ceil(value)} s` : `${Math.ceil(value / 60)} min`);
    return left === null || left === undefined ? `${text(seconds)} so far` : `${text(left)} left`;
}
