// SPDX-License-Identifier: Apache-2.0

// Shows the help of the key that has the focus or is under the pointer.

import {$, el} from "./dom.js";
import {applies, conditionText} from "./conditions.js";
import {formatNumber} from "./scale.js";
import {toToml} from "./toml.js";

function allowedText(key) {
    const range = key.min === undefined ? "" : `${formatNumber(key.min)} to ${formatNumber(key.max)}`;
    const word = key.word === undefined ? "" : `${toToml(key.word)} or `;
    switch (key.kind) {
        case "number":
            return `${word}${key.integer ? "an integer" : "a number"} from ${range}`;
        case "numbers":
            return `${key.length ?? "a list of"} ${key.integer ? "integers" : "numbers"} from ${range}`;
        case "color":
            return 'a color "#rrggbb"';
        case "colors":
            return 'a list of colors "#rrggbb", with positions from 0 to 1 if needed: "#rrggbb@0.25"';
        default:
            return "";
    }
}

function factsOf(key) {
    const facts = [
        ["Unit", key.unit],
        ["Allowed", allowedText(key)],
    ];
    if (key.default !== undefined) {
        facts.push(["Default", toToml(key.default)]);
    }
    return facts.filter(([, text]) => text !== "");
}

/** Shows the help of a key. `values` are the values of all keys. */
export function showHelp(key, values) {
    const condition = conditionText(key);
    $("form-help").replaceChildren(
        el("p", {class: "help-path"}, key.path),
        el("p", {class: "help-text"}, `${key.help[0].toUpperCase()}${key.help.slice(1)}.`),
        condition ? el("p", {class: applies(key, values) ? "help-condition" : "help-condition unmet"}, condition) : "",
        el("dl", {}, ...factsOf(key).flatMap(([name, text]) => [el("dt", {}, name), el("dd", {}, text)])),
    );
}
