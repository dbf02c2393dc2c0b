// SPDX-License-Identifier: Apache-2.0

// Maps the values of a preset key that is a number to positions of the key's slider, and writes numbers as text.

const kPositions = 1000; // largest position of a slider that is not linear
// A range from min >= 0 to max gets a logarithmic slider if both of these conditions hold (scaleOf):
// - max - min is more than kWide times the difference between the reference value (referenceOf) and min;
// - max - min is more than kSpan, or min is positive and max / min is more than 1000.
// A range with min < 0 gets a symmetric slider, logarithmic on both sides of 0, if max is at least 1000 and more than
// kWide times the reference value.
const kWide = 10;
const kSpan = 5;
const kMaxSliderRange = 1e9; // the widest range that has a slider

/**
 * Returns the number as text, with at most `digits` significant digits unless it is an integer.
 * Only very large and very small numbers have an exponent.
 */
export function formatNumber(value, digits = 6) {
    if (!Number.isFinite(value)) {
        return String(value);
    }
    return String(Number.isInteger(value) ? value : Number(value.toPrecision(digits)));
}

/**
 * Returns the scale of a slider, or null if the range of the key is too wide for a slider, such as
 * the range of a seed. A scale contains `min`, `max` and `step` of the slider, and the functions
 * `position`, from a value to a position, and `value`, from a position to a value. The range ends at
 * the largest value of the key or at `largest`, whichever is smaller.
 */
export function scaleOf(key, largest = Infinity) {
    const max = Math.min(key.max, largest);
    if (max - key.min > kMaxSliderRange) {
        return null;
    }
    const reference = referenceOf(key, max);
    if (key.min < 0) {
        return Math.abs(max) > kWide * reference && max >= 1000
            ? symmetricScale(key, max, reference)
            : linearScale(key, max);
    }
    const span = max - key.min;
    const wide = span / (reference - key.min) > kWide && (span > kSpan || (key.min > 0 && max / key.min > 1000));
    return wide ? logarithmicScale(key, max, reference) : linearScale(key, max);
}

// Returns the reference value, which determines the kind of the scale: the magnitude of the default,
// or a typical value if this magnitude is not inside the range.
function referenceOf(key, max) {
    const standard = typeof key.default === "number" ? Math.abs(key.default) : 0;
    if (standard > key.min && standard < max) {
        return standard;
    }
    const typical = key.min + (key.integer ? 10 : 1);
    return typical < max / 2 ? typical : key.min > 0 ? key.min * 1000 : max / 100;
}

function linearScale(key, max) {
    const step = key.integer ? 1 : 10 ** Math.floor(Math.log10((max - key.min) / 90));
    const digits = Math.max(0, -Math.floor(Math.log10(step)));
    return {
        min: key.min,
        max,
        step: key.integer ? 1 : "any",
        unit: step,
        position: (value) => value,
        value: (position) => Number(position.toFixed(digits)),
    };
}

// Returns a scale on which the position kPositions t, with t from 0 to 1, has the value
// min + s (exp(k t) - 1). Here s is `size` and k is `rate`. The scale is nearly linear far below the
// reference value and logarithmic above.
function logarithmicScale(key, max, reference) {
    const size = (reference - key.min) / 4;
    const rate = Math.log((max - key.min) / size + 1);
    const value = (position) => key.min + size * (Math.exp((rate * position) / kPositions) - 1);
    const position = (number) => (kPositions * Math.log(Math.max(0, number - key.min) / size + 1)) / rate;
    return {min: 0, max: kPositions, step: 1, position, value: (at) => rounded(value(at), key)};
}

// Returns a scale with the curve of logarithmicScale on each side of 0.
function symmetricScale(key, max, reference) {
    const half = logarithmicScale({...key, min: 0, integer: false}, max, reference);
    return {
        min: -kPositions,
        max: kPositions,
        step: 1,
        position: (value) => Math.sign(value) * half.position(Math.abs(value)),
        value: (position) => Math.sign(position) * half.value(Math.abs(position)),
    };
}

function rounded(value, key) {
    if (key.integer) {
        return value < 1000 ? Math.round(value) : Number(value.toPrecision(3));
    }
    return Number(value.toPrecision(3));
}

/** Returns the change of the value for one press of an arrow key in the number's text field. */
export function stepOf(key, value) {
    if (key.integer) {
        return 1;
    }
    const size = Math.abs(value) || (Math.min(key.max, 100) - Math.max(key.min, -100)) / 100;
    return 10 ** Math.floor(Math.log10(size) - 1);
}
