// SPDX-License-Identifier: Apache-2.0

// Keyboard shortcuts, and the overlay that lists them.

import {$, el} from "./dom.js";
import {randomSeed} from "./field_number.js";
import {toggleTheme} from "./theme.js";

// Returns the shortcuts in groups: [group, [keys, meaning, action], ...]. Keys are values of KeyboardEvent.key, with
// the prefix "Ctrl+" if the control key must be held.
function shortcutsOf(studio) {
    const {state, ui, view, player, toolbar, transport, events, compare, variations, bake, takeHome, gallery, form} =
        studio;
    const tiling = (count) => () => ui.set("tiling", count);
    const mode = (name) => () => ui.set("mode", ui.get("mode") === name ? "picture" : name);
    return [
        [
            "Time",
            [[" "], "play or pause", () => player.toggle()],
            [
                ["ArrowLeft", "ArrowRight"],
                "one frame back, one frame on",
                (key) => player.step(key === "ArrowLeft" ? -1 : 1),
            ],
            [
                ["Home", "End"],
                "first frame, last frame",
                (key) => player.step((key === "Home" ? 1 : player.count) - player.frame),
            ],
            [["[", "]"], "slower, faster", (key) => transport.stepSpeed(key === "[" ? -1 : 1)],
            [["e"], "add an event at this frame", () => events.add()],
        ],
        [
            "Picture",
            [["1", "2", "3"], "tiles in each direction", (key) => tiling(Number(key))()],
            [["+", "-"], "zoom in, zoom out", (key) => view.zoomBy(key === "+" ? Math.SQRT2 : Math.SQRT1_2)],
            [["f"], "fit into the window", () => view.fit()],
            [["p"], "one pixel of the preset is one pixel of the screen", () => view.setZoom(1 / devicePixelRatio)],
            [["m", "M"], "next map, previous map", (key) => toolbar.stepMap(key === "m" ? 1 : -1)],
            [["c"], "compare with the picture before the change", () => compare.toggle()],
            [["k"], "keep the picture for comparison", () => compare.keep()],
        ],
        [
            "Workspace",
            [["l"], "lit surface", mode("lit")],
            [["v"], "variations of the key that has the focus, or of the seed", () => variations.show(form.focusedKey)],
            [["g"], "open or close the gallery", () => gallery.toggle()],
            [["t"], "light or dark theme", () => toggleTheme()],
            [["Escape"], "back to the picture", () => ui.set("mode", "picture")],
            [["?"], "this list", () => $("help-dialog").showModal()],
        ],
        [
            "Settings",
            [["/"], "search keys", () => $("form-search").focus()],
            [["r"], "roll the dice for foam.seed", () => state.set("foam.seed", String(randomSeed()))],
            [["Ctrl+z"], "undo", () => state.undo()],
            [["Ctrl+Z", "Ctrl+y"], "redo", () => state.redo()],
        ],
        [
            "Files",
            [["b"], "bake", () => bake.open()],
            [["x"], "copy the command", () => takeHome.copyCommand()],
            [["s"], "save the preset", () => takeHome.askName()],
            [["d"], "download the frame", () => takeHome.download("frame")],
        ],
    ];
}

const kNames = {
    " ": "Space",
    ArrowLeft: "←",
    ArrowRight: "→",
    "Ctrl+Z": "Ctrl+Shift+Z",
    "Ctrl+z": "Ctrl+Z",
    "Ctrl+y": "Ctrl+Y",
    M: "Shift+M",
    Escape: "Esc",
};
const nameOf = (key) => kNames[key] ?? (key.length === 1 ? key.toUpperCase() : key);

// Returns true if the focused element uses the key itself, or if a dialog or a menu is open.
function isTaken(event) {
    const target = event.target;
    if (target.closest("dialog[open], [popover]:popover-open")) {
        return true;
    }
    if (target.matches("textarea, select, input:not([type=range], [type=radio], [type=checkbox])")) {
        return true;
    }
    if (target.matches("input[type=range], input[type=radio]") && /^(Arrow|Home|End|Page)/.test(event.key)) {
        return true;
    }
    return event.key === " " && target.matches("button, input, summary, a, [role=slider], [role=button]");
}

// Returns true if the element is a text field, but not if it is a number field whose text is unchanged since it was
// last shown or confirmed (`data-shown`, field_number.js). If true, Ctrl+Z and Ctrl+Y are left to the text field.
function isWriting(target) {
    return target.matches("textarea, input[type=text], input[type=search]") && target.value !== target.dataset.shown;
}

export class Shortcuts {
    #actions = new Map();

    constructor(studio) {
        const groups = shortcutsOf(studio);
        for (const [keys, , action] of groups.flatMap(([, ...rows]) => rows)) {
            keys.forEach((key) => this.#actions.set(key, action));
        }
        document.addEventListener("keydown", (event) => this.#onKey(event));
        $("help").addEventListener("click", () => $("help-dialog").showModal());
        $("help-close").addEventListener("click", () => $("help-dialog").close());
        this.#fillHelp(groups);
    }

    #onKey(event) {
        const control = event.ctrlKey || event.metaKey;
        const action = this.#actions.get((control ? "Ctrl+" : "") + event.key);
        const text = isWriting(event.target);
        if (!action || event.altKey || event.defaultPrevented || (control ? text : isTaken(event))) {
            return;
        }
        event.preventDefault();
        action(event.key);
    }

    #fillHelp(groups) {
        $("help-list").replaceChildren(
            ...groups.map(([name, ...rows]) =>
                el(
                    "section",
                    {},
                    el("h3", {}, name),
                    el(
                        "dl",
                        {},
                        ...rows.flatMap(([keys, meaning]) => [
                            el("dt", {}, ...keys.map((key) => el("kbd", {}, nameOf(key)))),
                            el("dd", {}, meaning),
                        ]),
                    ),
                ),
            ),
        );
    }
}
