// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <array>
#include <cstdint>

namespace foam::texgen {

// All inline functions of this file can be called in loops that the compiler vectorizes.

/// A value of noise, and its gradient.
struct NoiseValue {
    double value = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
};

/// Gradient noise with unit gradients has values from -1/sqrt(2) to 1/sqrt(2). Multiplied by this
/// factor, it has values from -1 to 1.
inline constexpr double kNoiseScale = 1.4142135623730951;

/// Returns a hash of 32 bits (the finalizer of MurmurHash3, A. Appleby).
inline std::uint32_t scrambled(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x85ebca6bU;
    x ^= x >> 13U;
    x *= 0xc2b2ae35U;
    return x ^ (x >> 16U);
}

/// Returns the largest integer that is not above x. Loops that call this function can be vectorized
/// for every SimdLevel. Precondition: the integer fits into 32 bits.
inline std::int32_t floor_of(double x) {
    const auto toward_zero = static_cast<std::int32_t>(x);
    return toward_zero - (x < toward_zero ? 1 : 0);
}

namespace detail {

// Returns the hash of row `y` of the lattice (the points with integer coordinates).
inline std::uint32_t row_hash(std::int32_t y, std::uint32_t seed) {
    return scrambled(static_cast<std::uint32_t>(y) + scrambled(seed));
}

// The unit gradients of lattice points: 16 directions, 22.5 degrees apart.
inline constexpr double kA = 0.9238795325112867;  // cosine of 22.5 degrees
inline constexpr double kB = 0.3826834323650898;  // sine of 22.5 degrees
inline constexpr double kC = 0.7071067811865476;  // cosine and sine of 45 degrees
inline constexpr std::array<double, 16> kGradientsX = {
    1, kA, kC, kB, 0, -kB, -kC, -kA, -1, -kA, -kC, -kB, 0, kB, kC, kA};
inline constexpr std::array<double, 16> kGradientsY = {
    0, kB, kC, kA, 1, kA, kC, kB, 0, -kB, -kC, -kA, -1, -kA, -kC, -kB};

// A plane (a linear function) that is 0 at a lattice point.
struct LatticePlane {
    double value;  // at the point where the noise is computed
    double slope_x;
    double slope_y;
};

// Returns the plane of a lattice point. `column` is the column of the lattice point, and `hash` is
// the hash of its row (row_hash). (x, y) is the point where the noise is computed, relative to the
// lattice point.
inline LatticePlane plane_of(std::int32_t column, std::uint32_t hash, double x, double y) {
    const std::uint32_t direction = scrambled(static_cast<std::uint32_t>(column) + hash) >> 28U;
    const double slope_x = kGradientsX.data()[direction];
    const double slope_y = kGradientsY.data()[direction];
    return {slope_x * x + slope_y * y, slope_x, slope_y};
}

}  // namespace detail

/// Returns gradient noise at the point (x, y). The points with integer coordinates form the
/// lattice, so that the features of the noise have the size 1. Each of the four lattice points
/// around (x, y) defines a plane. Quintic polynomials blend the four planes.
inline NoiseValue gradient_noise(double x, double y, std::uint32_t seed) {
    const std::int32_t column = floor_of(x);
    const std::int32_t row = floor_of(y);
    const double in_x = x - column;
    const double in_y = y - row;
    const auto blend = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
    const auto slope = [](double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); };
    const double u = blend(in_x);
    const double v = blend(in_y);
    const std::uint32_t lower = detail::row_hash(row, seed);
    const std::uint32_t upper = detail::row_hash(row + 1, seed);
    const detail::LatticePlane p00 = detail::plane_of(column, lower, in_x, in_y);
    const detail::LatticePlane p10 = detail::plane_of(column + 1, lower, in_x - 1.0, in_y);
    const detail::LatticePlane p01 = detail::plane_of(column, upper, in_x, in_y - 1.0);
    const detail::LatticePlane p11 = detail::plane_of(column + 1, upper, in_x - 1.0, in_y - 1.0);
    const auto blended = [u, v](double a00, double a10, double a01, double a11) {
        return a00 + u * (a10 - a00) + v * (a01 - a00) + u * v * (a00 - a10 - a01 + a11);
    };
    const double twist = p00.value - p10.value - p01.value + p11.value;
    return {blended(p00.value, p10.value, p01.value, p11.value),
            blended(p00.slope_x, p10.slope_x, p01.slope_x, p11.slope_x) +
                slope(in_x) * (p10.value - p00.value + v * twist),
            blended(p00.slope_y, p10.slope_y, p01.slope_y, p11.slope_y) +
                slope(in_y) * (p01.value - p00.value + u * twist)};
}

/// Returns the seed of an octave of noise. Octave 0 is the first one.
inline std::uint32_t seed_of_octave(std::uint32_t seed, int octave) {
    return seed + static_cast<std::uint32_t>(octave) * 0x9e3779b9U;
}

}  // namespace foam::texgen
