// SPDX-License-Identifier: Apache-2.0

// Maps the values of a number key to positions of its slider, and writes numbers.

const kPositions = 1000; // of a slider that is not linear
const kWide = 10; // a range this many times the reference value gets a logarithmic slider
const kSpan = 5; // narrower ranges that begin near 0 get a linear slider
const kLargestSlider = 1e9;

/** Returns the number with at most `digits` significant digits, without an exponent if it is moderate. */
export function formatNumber(value, digits = 6) {
    if (!Number.isFinite(value)) {
        return String(value);
    }
    return String(Number.isInteger(value) ? value : Number(value.toPrecision(digits)));
}

/**
 * Returns the scale of a slider, or null if the key has no slider because its range is too wide, such as that of a
 * seed. A scale has `min`, `max` and `step` of the slider, and the functions `position` and `value`. `largest` limits
 * the range.
 */
export function scaleOf(key, largest = Infinity) {
    const max = Math.min(key.max, largest);
    if (max - key.min > kLargestSlider) {
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

// The value that decides the scale: the default, or a typical value if the default is the minimum.
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

// value = min + s (exp(k t) - 1), where t goes from 0 to 1: nearly linear far below the reference, logarithmic above
// it.
function logarithmicScale(key, max, reference) {
    const size = (reference - key.min) / 4;
    const rate = Math.log((max - key.min) / size + 1);
    const value = (position) => key.min + size * (Math.exp((rate * position) / kPositions) - 1);
    const position = (number) => (kPositions * Math.log(Math.max(0, number - key.min) / size + 1)) / rate;
    return {min: 0, max: kPositions, step: 1, position, value: (at) => rounded(value(at), key)};
}

// The same curve on both sides of 0; the reference value is half way to each end.
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
