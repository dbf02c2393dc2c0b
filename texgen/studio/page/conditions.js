// SPDX-License-Identifier: Apache-2.0

// Decides whether a key has an effect, from the conditions in the schema.

import {toToml} from "./toml.js";

// Patterns such as "*.png" match the end of a text.
function matches(value, pattern) {
    if (typeof value === "number") {
        return Number(pattern) === value;
    }
    if (typeof value === "string") {
        return pattern.startsWith("*") ? value.toLowerCase().endsWith(pattern.slice(1)) : value === pattern;
    }
    return toToml(value) === pattern;
}

/**
 * Returns true if the condition of the key is met, or if the key has none. The program knows a few more cases in which
 * a key has no effect (`notes` in ../REQUESTS.md). `values` are the values of all keys by their path.
 */
export function applies(key, values) {
    if (!key.condition || !(key.condition.key in values)) {
        return true;
    }
    const {rule, key: other, values: listed} = key.condition;
    const met = listed.some((pattern) => matches(values[other], pattern));
    return rule === "unused-with" ? !met : met;
}

/** Returns the condition of a key as a sentence, or an empty text. */
export function conditionText(key) {
    if (!key.condition) {
        return "";
    }
    const {rule, key: other, values} = key.condition;
    const list = values.map((value) => (value === "[]" ? "an empty list" : value)).join(" or ");
    const start = {"only-for": "Only allowed with", "used-with": "Only used with", "unused-with": "Not used with"}[
        rule
    ];
    return `${start} ${other} = ${list}.`;
}
