// SPDX-License-Identifier: Apache-2.0

// Writes and reads values in the notation of TOML, which the option --set and preset files use.

/** Returns a string, a number, a boolean, or a list of such values in the notation of TOML. */
export function toToml(value) {
    if (typeof value === "string") {
        return JSON.stringify(value);
    }
    if (Array.isArray(value)) {
        return `[${value.map(toToml).join(", ")}]`;
    }
    return String(value);
}

/**
 * Returns the value of a text that `toToml` wrote. Returns the text itself if it is not such a
 * text.
 */
export function fromToml(text) {
    try {
        return JSON.parse(text);
    } catch {
        return text;
    }
}

/** Returns the `[[event]]` tables of a list of events. The values of an event's keys are texts in TOML. */
export function eventsToToml(events) {
    return events
        .map((event) => {
            const lines = Object.entries(event).map(([name, text]) => `${name} = ${text}\n`);
            return `[[event]]\n${lines.join("")}`;
        })
        .join("\n");
}
