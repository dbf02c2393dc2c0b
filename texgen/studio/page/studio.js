// SPDX-License-Identifier: Apache-2.0

// Connects the parts of the page. After each edit of the document (the preset with the changes of the page, state.js),
// sends the requests /api/settings and /api/picture at the same time.

import {ApiError, connection, post} from "./api.js";
import {$, reducedMotion} from "./dom.js";
import {bakedSource, settingsSource} from "./source.js";
import {createParts} from "./parts.js";
import {eventKindsOf, tablesOf} from "./schema.js";
import {Form} from "./form.js";
import {Lane} from "./lane.js";
import {Painter} from "./painter.js";
import {Player} from "./player.js";
import {Signal} from "./signal.js";
import {StudioState} from "./state.js";
import {Ui} from "./ui.js";
import {View} from "./view.js";

const kPatience = 1000; // milliseconds after which a newer request for settings cancels a running one

export class Studio {
    /** Emits each answer of /api/settings that belongs to the newest settings. */
    answered = new Signal();
    /**
     * Emits when the picture is requested anew: after an edit, when the map, the width or the source (the document or
     * a baked set) changes, and when an answer shows that the request was based on a wrong guess.
     */
    refreshed = new Signal();
    /** Emits {key, message} if the newest settings are not allowed. */
    rejected = new Signal();

    /** The last answer of /api/settings, or null. */
    answer = null;
    /** The baked set that is shown instead of the document, or null. */
    baked = null;

    #settings = new Lane(kPatience);
    #edits = 0;
    #opened = true;

    /** `program` is the answer of /api/program. */
    constructor(program) {
        this.program = program;
        this.ui = new Ui();
        this.state = new StudioState(program.presets[0].name);
        this.view = new View($("picture"));
        this.player = new Player();
        this.painter = new Painter(this.view, this.player, this.ui);
        this.form = new Form(tablesOf(program.schema), this.state, program.largest_foam);
        this.eventKinds = eventKindsOf(program.schema);
        createParts(this);
    }

    /** Requests the first picture. */
    start() {
        this.player.frame = this.ui.get("frame");
        this.player.framed.on((frame) => this.ui.set("frame", frame));
        this.player.speed = this.ui.get("speed");
        this.state.changed.on((change) => this.#onEdit(change));
        this.ui.on(["map", "width"], () => this.#refresh({}));
        connection.on((state) => state === "online" && this.#onEdit({foam: true, live: false, keys: []}));
        window.addEventListener("pagehide", () => this.state.storeNow());
        this.#onEdit({foam: true, live: false, keys: []});
    }

    /** The entry of the preset in /api/program, or undefined for a file. */
    get presetInfo() {
        return this.program.presets.find((preset) => preset.name === this.state.preset);
    }

    /** The map that is shown. */
    get map() {
        const chosen = this.ui.get("map");
        if (this.baked) {
            const names = this.baked.maps.map((map) => map.name);
            return names.includes(chosen) ? chosen : names[0];
        }
        return chosen ?? (this.#currentAnswer?.maps ?? this.presetInfo?.maps)?.[0] ?? "lit";
    }

    /** Opens a preset or a file. Unsaved changes can be brought back with undo. */
    open(preset) {
        const same = preset === this.state.preset && this.state.changes.length === 0 && this.state.events === null;
        this.closeBaked(same);
        if (!same) {
            this.state.open(preset);
        }
    }

    /** Shows a baked set: an entry of /api/bakes. */
    openBaked(bake) {
        this.baked = bake;
        this.view.setSize(bake.size);
        this.player.frame = 1;
        this.player.configure(bake.frames.length, bake.frames_per_second);
        // Setting the map requests pictures, so the number of frames must be known before.
        this.ui.set("map", bake.maps[0].name);
        document.body.classList.add("baked");
        this.#refresh({foam: true});
        this.#playAtFirst();
    }

    /** Shows the document again instead of a baked set. */
    closeBaked(refresh = true) {
        if (this.baked) {
            this.baked = null;
            this.ui.set("map", null);
            document.body.classList.remove("baked");
            if (refresh) {
                this.#onEdit({foam: true, live: false, keys: []});
            }
        }
    }

    get #currentAnswer() {
        return this.answer?.requested === this.state.preset ? this.answer : null;
    }

    get #size() {
        return this.#currentAnswer?.size ?? this.presetInfo?.size ?? [512, 512];
    }

    #onEdit({foam, live, opened}) {
        this.#edits += 1;
        if (opened) {
            this.#onOpen();
        }
        this.form.showChanges();
        this.#requestSettings();
        if (!this.baked) {
            this.#limitFrames();
            this.#refresh({foam, live});
        }
    }

    // Limits the current frame to the probable number of frames: the picture is requested before
    // the answer to the settings is known, and the server rejects frames beyond the end.
    #limitFrames() {
        const count = Number(this.state.change("frames.count") ?? this.presetInfo?.frames);
        if (count >= 1 && count < this.player.count) {
            this.player.configure(count, this.player.framesPerSecond);
        }
    }

    #onOpen() {
        this.#opened = true;
        this.form.scrollToTop();
        this.ui.set("map", null);
        this.player.frame = 1;
    }

    // Requests the picture of the document, or of the baked set that is shown instead.
    #refresh(how) {
        this.painter.setSource(this.#source());
        this.painter.refresh(how);
        this.refreshed.emit(how);
    }

    #source() {
        const largestWidth = this.program.largest_width;
        if (this.baked) {
            return bakedSource(this.baked, this.map, largestWidth);
        }
        const transparent = this.#currentAnswer?.tiles === false;
        return settingsSource(this.state.settings(), {size: this.#size, map: this.map, largestWidth, transparent});
    }

    #requestSettings() {
        const settings = this.state.settings();
        const edit = this.#edits;
        this.#settings.run(async (signal) => {
            try {
                const answer = await post("/api/settings", {settings}, signal);
                if (edit === this.#edits) {
                    await this.#onAnswer({...answer, requested: settings.preset}, settings);
                }
            } catch (error) {
                if (error instanceof ApiError && edit === this.#edits && error.status !== 403) {
                    this.form.showError(error);
                    this.rejected.emit(error);
                }
            }
        });
    }

    async #onAnswer(answer, settings) {
        const before = {answer: this.#currentAnswer, size: this.#size, map: this.map, frame: this.player.frame};
        this.answer = answer;
        if (!this.baked) {
            this.view.setSize(answer.size);
            this.player.configure(answer.frames, answer.frames_per_second);
            this.#correctPicture(before);
        }
        this.form.showAnswer(answer);
        this.answered.emit(answer);
        if (this.#opened && !this.baked) {
            this.#opened = false;
            this.#playAtFirst();
        }
        if (this.state.base === null) {
            await this.#requestBase(answer, settings);
        }
    }

    // The picture was requested before the answer was known, with a guess of its size, its map, its frame, and whether
    // the foam tiles. Requests it again if one of these guesses was wrong.
    #correctPicture(before) {
        const {answer} = this;
        const wrong =
            before.size[0] !== answer.size[0] ||
            before.size[1] !== answer.size[1] ||
            before.map !== this.map ||
            before.frame !== this.player.frame ||
            (before.answer ? before.answer.tiles !== answer.tiles : !answer.tiles);
        if (wrong) {
            this.#refresh({foam: !this.painter.showsFrame});
        } else if (before.answer && before.answer.simulation !== answer.simulation) {
            this.painter.addDraft();
        }
    }

    // Requests the values of the preset without the changes of the page. They determine which
    // sections of the form are open, and which edits are no changes.
    async #requestBase(answer, settings) {
        const plain = settings.set.length === 0 && settings.events === null;
        const base = plain ? answer : await post("/api/settings", {settings: {...settings, set: [], events: null}});
        if (settings.preset === this.state.preset) {
            this.state.base = base.values;
            this.form.showPreset(base.values);
        }
    }

    // Plays an animation that has just been opened, unless the user prefers less motion.
    #playAtFirst() {
        if (!reducedMotion()) {
            this.player.play();
        }
    }
}
