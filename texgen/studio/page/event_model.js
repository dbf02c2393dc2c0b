// SPDX-License-Identifier: Apache-2.0

// Events as the page keeps them: objects whose values are texts in TOML.

import {fromToml, toToml} from "./toml.js";

const kLength = 10; // frames of a new event
const kLastFrame = 100000; // the last frame that can have events: kLastEventFrame in texgen/events/event_base.h
const kSameTime = 1e-6; // times that differ by less than this fraction of a time step count as equal

/** Returns the events of an answer of /api/settings as the page keeps them. */
export const toTexts = (events) =>
    events.map((event) => Object.fromEntries(Object.entries(event).map(([name, value]) => [name, toToml(value)])));

/** Returns the kind of an event. */
export const kindOf = (event) => fromToml(event.kind);

/** Returns the frames of an event: [first, last]. `values` are the values of the preset's keys. */
export function rangeOf(event, values) {
    if (event.frames) {
        return fromToml(event.frames);
    }
    if (event.frame) {
        return [fromToml(event.frame), fromToml(event.frame)];
    }
    const times = [fromToml(event.time ?? "0")].flat();
    return framesBetween(times[0], times.at(-1), values);
}

const without = (event, names) => Object.fromEntries(Object.entries(event).filter(([name]) => !names.includes(name)));

/** Returns the event with other frames. */
export function withRange(event, [first, last]) {
    const rest = without(event, ["frame", "frames", "time"]);
    return first === last ? {...rest, frame: String(first)} : {...rest, frames: `[${first}, ${last}]`};
}

/** Returns the event with another value of a key; null removes the key. */
export function withValue(event, name, text) {
    const rest = without(event, [name]);
    return text === null ? rest : {...rest, [name]: text};
}

// Returns the first and the last frame of an event that lasts from one foam time to another, as frames_of in
// texgen/preset/event_frames.cpp does. Frame 1 shows the time frames.warm_up and cannot have events. Each step is
// frames.step_growth times as long as the step before it.
function framesBetween(from, to, values) {
    const growth = values["frames.step_growth"] ?? 1;
    let step = values["frames.time_step"] || 1;
    let time = (values["frames.warm_up"] ?? 0) + step;
    let frame = 2;
    const advanceWhile = (condition) => {
        for (; frame < kLastFrame && condition(); ++frame) {
            step *= growth;
            time += step;
        }
    };
    advanceWhile(() => from < to && time <= from + kSameTime * step);
    const first = frame;
    advanceWhile(() => time < to - kSameTime * step);
    return [from < to ? first : frame, frame];
}

/** Returns a new event of a kind (see schema.js) that begins near a frame. */
export function newEvent(kind, frame, count) {
    const first = Math.min(Math.max(2, frame), count);
    const event = withRange({kind: toToml(kind.name)}, [first, Math.min(count, first + kLength - 1)]);
    return kind.keys.some((key) => key.name === "at") ? {...event, at: "[0.5, 0.5]"} : event;
}

/** Returns an event of the given kind. It keeps the values of those keys of `event` that this kind has, too. */
export function withKind(event, kind) {
    const names = new Set(kind.keys.map((key) => key.name));
    const kept = Object.entries(event).filter(([name]) => names.has(name));
    return {kind: toToml(kind.name), ...Object.fromEntries(kept)};
}
