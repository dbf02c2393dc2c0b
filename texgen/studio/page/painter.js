// SPDX-License-Identifier: Apache-2.0

// Decides which pictures are requested, and shows them. While a control is moved, these are drafts
// (frame 1 without the warm-up, the events and the loop) or pictures of a small width. When the
// control rests, it is the full picture (the simulated frame), then the other frames of the loop.

import {ApiError, ConnectionError} from "./api.js";
import {debounce} from "./dom.js";
import {Lane} from "./lane.js";
import {Signal} from "./signal.js";

const kPatience = 120; // milliseconds after which a newer request cancels a running one
const kRest = 150; // milliseconds without an edit after which a dragged control rests
const kSlow = 50; // if a full picture takes more milliseconds, a drag requests small pictures
const kSmall = 256; // largest width of small pictures, in pixels
const kLoad = 400; // milliseconds from the full picture to the loop, if the edit does not change the foam
const kSharpen = 600; // milliseconds of rest after which a magnified picture is requested at full size
// Ranks of pictures: a picture does not replace one of the same edit that has a higher rank.
const kDraft = 0,
    kSmaller = 1,
    kFull = 2,
    kSharp = 3;

export class Painter {
    /**
     * Emits {busy, message, error}. `busy` is true while a full picture is awaited; `error` is the
     * ApiError of the last request for a picture, if it failed; `message` is its message, or null.
     */
    status = new Signal();
    /**
     * Emits each picture of a simulated frame, small ones included, unless an edit has followed its request. Does not
     * emit drafts, sharpened pictures and the pictures that the player loads.
     */
    painted = new Signal();

    #view;
    #player;
    #ui;
    #source = null;
    #draft = new Lane(kPatience);
    #full = new Lane(kPatience);
    #sharp = new Lane(kPatience);
    #edit = 0; // the number of the newest edit; counts the calls of `refresh`
    #shownEdit = 0; // the edit of the shown picture
    #shownRank = 0; // its rank
    #fullTime = 0; // milliseconds that the last full picture took
    #showsFrame = false;
    #rest = debounce(kRest, () => this.#paint());
    #sharpen = debounce(kSharpen, () => this.#paintSharp());
    #load = debounce(kLoad, (picture) => this.#loadLoop(picture));

    constructor(view, player, ui) {
        this.#view = view;
        this.#player = player;
        this.#ui = ui;
        player.framed.on((frame, picture) => this.#onFrame(picture));
        player.changed.on(() => player.playing && this.#sharpen.cancel());
        view.moved.on(() => this.#sharpen());
    }

    /** The source of the pictures (source.js). */
    get source() {
        return this.#source;
    }

    /** Sets the source of the pictures. Does not request a picture. */
    setSource(source) {
        this.#source = source;
    }

    /** True if a simulated frame of the current foam, not only a draft, has been shown. */
    get showsFrame() {
        return this.#showsFrame;
    }

    /**
     * Requests the picture again after an edit. `foam` is true if the foam changes; `live` is true
     * while the control is being moved.
     */
    refresh({foam = false, live = false} = {}) {
        this.#edit += 1;
        this.#player.clear();
        this.#sharpen.cancel();
        this.#sharp.stop();
        this.#load.cancel();
        this.#showsFrame &&= !foam;
        if (!this.#showsFrame && this.#source.drafts) {
            this.#paintDraft(live);
        }
        if (!live) {
            this.#rest.cancel();
            this.#paint();
            return;
        }
        this.#rest();
        if (this.#showsFrame) {
            this.#paint(this.#fullTime > kSlow ? Math.min(kSmall, this.width) : this.width, true);
        } else {
            this.#full.stop();
        }
    }

    /** Requests a draft as well. Called when the last edit turns out to change the foam. */
    addDraft() {
        if (this.#showsFrame && this.#shownEdit < this.#edit) {
            this.#showsFrame = false;
            this.#paintDraft(false);
        }
    }

    /** The width of full pictures in pixels. */
    get width() {
        const chosen = this.#ui.get("width");
        const wanted = chosen < 0 ? this.#view.suitableWidth : chosen || Infinity;
        return Math.min(wanted, this.#source.size[0], this.#source.largestWidth);
    }

    #paintDraft(live) {
        const edit = this.#edit;
        const source = this.#source;
        const width = live ? Math.min(kSmall, this.width) : Math.min(512, this.width);
        this.#draft.run((signal) => this.#request(edit, kDraft, () => source.picture(1, width, "draft", signal)));
    }

    #paint(width = this.width, live = false) {
        const edit = this.#edit;
        const source = this.#source;
        const frame = this.#player.frame;
        this.status.emit({busy: true, message: null});
        this.#full.run(async (signal) => {
            const start = performance.now();
            const rank = width < this.width ? kSmaller : kFull;
            // If the animation has only one frame, the server can fit the range of a bake at once. The range of a loop
            // needs all frames (Player.load).
            const quality = live || this.#player.count > 1 ? "full" : "exact";
            const picture = await this.#request(edit, rank, () => source.picture(frame, width, quality, signal));
            if (picture && width === this.width && source === this.#source) {
                this.#fullTime = performance.now() - start;
            }
            if (picture && edit === this.#edit) {
                const first = !this.#showsFrame;
                this.#showsFrame = true;
                this.status.emit({busy: false, message: null});
                this.painted.emit(picture);
                if (rank === kFull && !live) {
                    first || this.#player.loaded > 0 ? this.#loadLoop(picture) : this.#load(picture);
                    this.#sharpen();
                }
            }
        });
    }

    #loadLoop(picture) {
        const source = this.#source;
        const width = this.#player.loopWidth(this.width, source.size[1] / source.size[0]);
        if (picture.width === width) {
            this.#player.put(picture.frame, picture);
        }
        if (this.#player.count > 1 && !this.#player.complete) {
            this.#player.load((frame, quality, signal) => source.picture(frame, width, quality, signal));
        }
    }

    async #request(edit, rank, ask) {
        try {
            const picture = await ask();
            this.#show(edit, rank, picture);
            return picture;
        } catch (error) {
            const isAnswer = error instanceof ApiError;
            if (isAnswer && error.status === 409) {
                this.#askAgain(edit);
            } else if (isAnswer && edit === this.#edit) {
                this.status.emit({busy: false, message: error.message, error});
            } else if (!isAnswer && !(error instanceof ConnectionError) && error.name !== "AbortError") {
                throw error;
            }
            return null;
        }
    }

    // Requests the full picture again if its simulation was stopped (status 409). This can happen
    // if a request about an earlier foam reaches the server late.
    #askAgain(edit) {
        setTimeout(() => {
            if (edit === this.#edit && !this.#full.busy) {
                this.#paint();
            }
        }, kRest);
    }

    #show(edit, rank, picture) {
        if (edit < this.#shownEdit || (edit === this.#shownEdit && rank < this.#shownRank)) {
            return;
        }
        this.#shownEdit = edit;
        this.#shownRank = rank;
        this.#view.show(picture);
    }

    // Shows a frame of the loop, or requests it if it is not loaded.
    #onFrame(picture) {
        if (picture) {
            this.#shownEdit = this.#edit;
            this.#shownRank = kFull;
            this.#view.show(picture);
            if (!this.#player.playing) {
                this.#sharpen();
            }
        } else if (this.#source) {
            this.#shownEdit = this.#edit;
            this.#shownRank = kDraft;
            this.#paint();
        }
    }

    // Requests the picture at the full size of the images (`size` of the source), or at the largest
    // width that is allowed, if the shown picture is smaller and the screen magnifies its pixels.
    #paintSharp() {
        const source = this.#source;
        const current = this.#view.picture;
        if (!source || !current || !current.exact || this.#player.playing || this.#full.busy || !this.#showsFrame) {
            return;
        }
        const full = Math.min(source.size[0], source.largestWidth);
        if (current.width >= full || this.#view.deviceZoom * source.size[0] < 1.2 * current.width) {
            return;
        }
        const edit = this.#edit;
        const frame = this.#player.frame;
        this.#sharp.run((signal) =>
            this.#request(edit, kSharp, async () => {
                const picture = await source.picture(frame, full, "full", signal);
                if (frame !== this.#player.frame || this.#player.playing) {
                    throw new DOMException("Another frame is shown.", "AbortError");
                }
                return picture;
            }),
        );
    }
}
