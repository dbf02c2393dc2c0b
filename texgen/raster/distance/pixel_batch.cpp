// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/pixel_batch.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace foam::texgen {

namespace {

// Distances to arcs are kept as fractions 2 |f| / (1 + |grad f|), where f is ArcFunctions::across.
// Fractions are compared by cross-multiplication, which avoids a division per arc. Smooth distances
// follow Biswas and Shapiro (README.md): they are computed from approximate distances phi to single
// films (add_film). The innermost loops are over pixels and have no branches, so that compilers
// vectorize them.

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// A pixel faces an arc if it is between the normals at both ends of the arc. A pixel that is at
// most this many pixels beyond one of the normals still faces the arc. Without this, rounding could
// leave a gap between two arcs that continue each other smoothly.
constexpr float kPastEnd = 1e-3F;
// The smallest phi² of a film (see add_film), in square pixels. It keeps the inverse within the
// range of floats.
constexpr float kMinSquare = 1e-12F;
// The smallest value of `root` in add_film. It avoids 0 / 0 at the ends of a film.
constexpr float kMinRoot = 1e-18F;
// A sum of 1/phi², in 1 / square pixels, counts as 0 up to this limit: the smooth distance would be
// at least 1e6 pixels.
constexpr float kMinSum = 1e-12F;

// One float for each of the kLanes pixels that are measured at once. These pixels are called a
// block.
using Lanes = KernelArray<float, PixelBatch::kLanes>;

// The function mask_if returns a mask of 32 bits: all ones if the condition is true, else all
// zeros. The function `chosen` returns `first` if `mask` is all ones, and `second` if `mask` is all
// zeros.
std::uint32_t mask_if(bool condition) {
    return condition ? ~std::uint32_t{0} : 0;
}
float chosen(std::uint32_t mask, float first, float second) {
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(first) & mask) |
                                (std::bit_cast<std::uint32_t>(second) & ~mask));
}

// A distance as a fraction, so that distances are compared without a division.
struct Fraction {
    float numerator;  // infinite if the pixel does not face the arc
    float denominator;
};

// The smallest distance so far of each pixel of a block, and a vector in the direction of the
// gradient of this distance. The length of the vector is arbitrary.
struct Nearest {
    Lanes numerator{};
    Lanes denominator{};
    Lanes gradient_x{};
    Lanes gradient_y{};

    // Replaces the distance of pixel k, and the vector, if the given distance is smaller.
    template <bool kGradient>
    [[gnu::always_inline]] void take(std::size_t k, Fraction distance, float x, float y) {
        const std::uint32_t nearer =
            mask_if(distance.numerator * denominator[k] < numerator[k] * distance.denominator);
        numerator[k] = chosen(nearer, distance.numerator, numerator[k]);
        denominator[k] = chosen(nearer, distance.denominator, denominator[k]);
        if constexpr (kGradient) {
            gradient_x[k] = chosen(nearer, x, gradient_x[k]);
            gradient_y[k] = chosen(nearer, y, gradient_y[k]);
        }
    }
};

// The value and the gradient of a FloatQuadratic at a point.
struct ValueAndGradient {
    float twice_value;  // twice the value
    float x;            // the gradient
    float y;
};

[[gnu::always_inline]] inline ValueAndGradient evaluate(const FloatQuadratic& f, float x, float y) {
    const float slope_x = f.x - f.curvature * x;
    const float slope_y = f.y - f.curvature * y;
    return {f.twice_value + x * (f.x + slope_x) + y * (f.y + slope_y), slope_x, slope_y};
}

[[gnu::always_inline]] inline float at(const FloatLine& line, float x, float y) {
    return line.value + x * line.x + y * line.y;
}

template <bool kGradient>
[[gnu::always_inline]] inline void take_arc(const ArcFunctions& arc,
                                            const float* x,
                                            const float* y,
                                            Nearest& nearest) {
    for (std::size_t k = 0; k < PixelBatch::kLanes; ++k) {
        const ValueAndGradient f = evaluate(arc.across, x[k], y[k]);
        const float slope = std::sqrt(f.x * f.x + f.y * f.y);
        const float end = min_value(at(arc.past_tail, x[k], y[k]), at(arc.before_head, x[k], y[k]));
        const float numerator = end >= -kPastEnd ? std::abs(f.twice_value) : kInfinity;
        const float sign = std::copysign(1.0F, f.twice_value);
        nearest.take<kGradient>(k, {numerator, 1.0F + slope}, sign * f.x, sign * f.y);
    }
}

template <bool kGradient>
[[gnu::always_inline]] inline void take_point(const Vec2& point,
                                              const float* x,
                                              const float* y,
                                              Nearest& nearest) {
    const auto point_x = static_cast<float>(point.x());
    const auto point_y = static_cast<float>(point.y());
    for (std::size_t k = 0; k < PixelBatch::kLanes; ++k) {
        const float to_x = x[k] - point_x;
        const float to_y = y[k] - point_y;
        nearest.take<kGradient>(k, {std::sqrt(to_x * to_x + to_y * to_y), 1.0F}, to_x, to_y);
    }
}

// The arrays into which values and their gradients are written.
struct BatchArrays {
    float* value;
    float* x;
    float* y;
};

// Measures the distances of `count` pixels. Returns true if all distances are finite.
template <bool kGradient>
[[gnu::always_inline]] inline bool find_nearest(std::span<const ArcFunctions> arcs,
                                                std::span<const Vec2> points,
                                                std::size_t count,
                                                const float* xs,
                                                const float* ys,
                                                const BatchArrays& to) {
    std::uint32_t any_far = 0;
    for (std::size_t from = 0; from < count; from += PixelBatch::kLanes) {
        Nearest nearest;
        nearest.numerator.fill(kInfinity);
        nearest.denominator.fill(1.0F);
        for (const ArcFunctions& arc : arcs) {
            take_arc<kGradient>(arc, xs + from, ys + from, nearest);
        }
        for (const Vec2& point : points) {
            take_point<kGradient>(point, xs + from, ys + from, nearest);
        }
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loops
        for (std::size_t k = 0; k < PixelBatch::kLanes; ++k) {
            any_far |= mask_if(nearest.numerator[k] == kInfinity);
            to.value[from + k] = nearest.numerator[k] / nearest.denominator[k];
        }
#pragma GCC unroll 1
        for (std::size_t k = 0; k < (kGradient ? PixelBatch::kLanes : 0); ++k) {
            const float x = nearest.gradient_x[k];
            const float y = nearest.gradient_y[k];
            const float length = std::sqrt(x * x + y * y);
            const float scale = length > 0.0F ? 1.0F / length : 0.0F;
            to.x[from + k] = scale * x;
            to.y[from + k] = scale * y;
        }
    }
    return any_far == 0;
}

// The sums over films from which smooth distances and their gradients are computed.
struct SmoothSums {
    Lanes sum{};
    Lanes x{};
    Lanes y{};
};

// Adds a film to the sums. Let f be the value of film.across, t the value of film.along, and c the
// length of the chord. The approximate distance phi to the film is given by phi² = f² + r². Here
// r = (root - t) / 2 and root = sqrt(t² + f^4 / c²). The gradient of r satisfies
// r grad r = r (f³ / c² grad f - r grad t) / root.
template <bool kGradient>
[[gnu::always_inline]] inline void add_film(const FilmFunctions& film,
                                            const float* xs,
                                            const float* ys,
                                            SmoothSums& sums) {
    const float inverse_chord = 1.0F / film.chord;
    for (std::size_t k = 0; k < PixelBatch::kLanes; ++k) {
        const ValueAndGradient across = evaluate(film.across, xs[k], ys[k]);
        const ValueAndGradient along = evaluate(film.along, xs[k], ys[k]);
        const float f = 0.5F * across.twice_value;
        const float t = 0.5F * along.twice_value;
        const float bend = f * f * inverse_chord;
        const float root = max_value(std::sqrt(t * t + bend * bend), kMinRoot);
        const float sum = root + std::abs(t);
        const float inside = 0.5F * bend * (bend / sum);  // (root - t) / 2 without cancellation
        const float r = t > 0.0F ? inside : 0.5F * sum;
        const float weight = 1.0F / max_value(f * f + r * r, kMinSquare);
        sums.sum[k] += weight;
        if constexpr (kGradient) {
            const float part = r / root;  // at most 1
            const float from_f = f + part * (f * inverse_chord) * bend;
            const float from_t = -part * r;
            const float scale = weight * weight;
            sums.x[k] += scale * (from_f * across.x + from_t * along.x);
            sums.y[k] += scale * (from_f * across.y + from_t * along.y);
        }
    }
}

// Measures smooth distances: s = S^-1/2, where S is the sum of 1/phi². The gradient of s is s³
// times the sum of phi^-4 (f grad f + r grad r). If S is at most kMinSum, or NaN, the plain
// distance and its gradient replace s and its gradient. Returns false if any distance was replaced.
template <bool kGradient>
[[gnu::always_inline]] inline bool sum_films(std::span<const FilmFunctions> films,
                                             std::size_t count,
                                             const float* xs,
                                             const float* ys,
                                             const BatchArrays& plain,
                                             const BatchArrays& to) {
    std::uint32_t any_lost = 0;
    for (std::size_t from = 0; from < count; from += PixelBatch::kLanes) {
        SmoothSums sums;
        for (const FilmFunctions& film : films) {
            add_film<kGradient>(film, xs + from, ys + from, sums);
        }
#pragma GCC unroll 1
        for (std::size_t k = 0; k < PixelBatch::kLanes; ++k) {
            const float s = 1.0F / std::sqrt(sums.sum[k]);
            const std::uint32_t is_lost = mask_if(!(sums.sum[k] > kMinSum));
            any_lost |= is_lost;
            to.value[from + k] = chosen(is_lost, plain.value[from + k], s);
            if constexpr (kGradient) {
                const float scale = s * s * s;
                to.x[from + k] = chosen(is_lost, plain.x[from + k], scale * sums.x[k]);
                to.y[from + k] = chosen(is_lost, plain.y[from + k], scale * sums.y[k]);
            }
        }
    }
    return any_lost == 0;
}

}  // namespace

void PixelBatch::clear(const Vec2& middle) {
    middle_ = middle;
    to_middle_x_ = static_cast<float>(middle.x() - 0.5);
    to_middle_y_ = static_cast<float>(middle.y() - 0.5);
    count_ = 0;
    span_count_ = 0;
}

// Gives the lanes after the last pixel copies of the first pixel.
void PixelBatch::pad() {
    std::fill_n(&x_[count_], kLanes, x_[0]);
    std::fill_n(&y_[count_], kLanes, y_[0]);
}

bool PixelBatch::measure(std::span<const ArcFunctions> arcs,
                         std::span<const Vec2> points,
                         bool gradient) {
    pad();
    const BatchArrays to{distance_.data(), gradient_x_.data(), gradient_y_.data()};
    const auto measure_with =
        [=, count = padded_count(), xs = x_.data(), ys = y_.data()](auto with_gradient) {
            return at_simd_level(
                [=] { return find_nearest<with_gradient>(arcs, points, count, xs, ys, to); });
        };
    return gradient ? measure_with(std::true_type{}) : measure_with(std::false_type{});
}

bool PixelBatch::measure_smooth(std::span<const FilmFunctions> films, bool gradient) {
    pad();
    const BatchArrays plain{distance_.data(), gradient_x_.data(), gradient_y_.data()};
    const BatchArrays to{smooth_.data(), smooth_x_.data(), smooth_y_.data()};
    const auto measure_with =
        [=, count = padded_count(), xs = x_.data(), ys = y_.data()](auto with_gradient) {
            return at_simd_level(
                [=] { return sum_films<with_gradient>(films, count, xs, ys, plain, to); });
        };
    return gradient ? measure_with(std::true_type{}) : measure_with(std::false_type{});
}

}  // namespace foam::texgen
