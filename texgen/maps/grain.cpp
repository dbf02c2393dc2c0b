// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/grain.h"

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"

#include <array>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr int kMaxOctaves = 5;
constexpr double kSmallestFeature = 2.0;  // pixels; octaves of smaller features are left out
// The magnitude of gradient noise with unit gradients is at most 1/sqrt(2). This factor spreads one
// octave to the range from -1 to 1.
constexpr double kScale = 1.4142135623730951;

// A hash of 32 bits (the finalizer of MurmurHash3, A. Appleby).
std::uint32_t scrambled(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x85ebca6bU;
    x ^= x >> 13U;
    x *= 0xc2b2ae35U;
    return x ^ (x >> 16U);
}

// Returns the hash of a row of the lattice.
std::uint32_t row_hash(std::int32_t y, std::uint32_t seed) {
    return scrambled(static_cast<std::uint32_t>(y) + scrambled(seed));
}

// Returns the unit gradient of a lattice point in the row with the given hash: one of 16
// directions, 22.5 degrees apart.
Vec2 lattice_gradient(std::int32_t x, std::uint32_t row) {
    constexpr double kA = 0.9238795325112867;  // cosine of 22.5 degrees
    constexpr double kB = 0.3826834323650898;  // sine of 22.5 degrees
    constexpr double kC = 0.7071067811865476;  // cosine of 45 degrees
    static constexpr std::array<std::array<double, 2>, 16> kDirections = {{{1, 0},
                                                                           {kA, kB},
                                                                           {kC, kC},
                                                                           {kB, kA},
                                                                           {0, 1},
                                                                           {-kB, kA},
                                                                           {-kC, kC},
                                                                           {-kA, kB},
                                                                           {-1, 0},
                                                                           {-kA, -kB},
                                                                           {-kC, -kC},
                                                                           {-kB, -kA},
                                                                           {0, -1},
                                                                           {kB, -kA},
                                                                           {kC, -kC},
                                                                           {kA, -kB}}};
    const std::uint32_t hash = scrambled(static_cast<std::uint32_t>(x) + row);
    const auto& [across, up] = kDirections[hash >> 28U];
    return {across, up};
}

// Returns gradient noise on the lattice of the points with integer coordinates, so that its
// features have the size 1. Each of the four lattice points around the point defines a plane (a
// linear function), which is 0 at the lattice point and has the gradient that lattice_gradient
// returns. Quintic polynomials blend the four planes.
GrainValue gradient_noise(const Vec2& point, std::uint32_t seed) {
    const double left = std::floor(point.x());
    const double bottom = std::floor(point.y());
    const auto x = static_cast<std::int32_t>(left);
    const auto y = static_cast<std::int32_t>(bottom);
    const Vec2 in(point.x() - left, point.y() - bottom);
    const auto blend = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
    const auto slope = [](double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); };
    const double u = blend(in.x());
    const double v = blend(in.y());
    const std::uint32_t lower = row_hash(y, seed);
    const std::uint32_t upper = row_hash(y + 1, seed);
    const Vec2 g00 = lattice_gradient(x, lower);
    const Vec2 g10 = lattice_gradient(x + 1, lower);
    const Vec2 g01 = lattice_gradient(x, upper);
    const Vec2 g11 = lattice_gradient(x + 1, upper);
    const double p00 = g00.dot(in);
    const double p10 = g10.dot(in - Vec2(1.0, 0.0));
    const double p01 = g01.dot(in - Vec2(0.0, 1.0));
    const double p11 = g11.dot(in - Vec2(1.0, 1.0));
    const double twist = p00 - p10 - p01 + p11;
    const Vec2 planes = g00 + u * (g10 - g00) + v * (g01 - g00) + u * v * (g00 - g10 - g01 + g11);
    return {p00 + u * (p10 - p00) + v * (p01 - p00) + u * v * twist,
            planes + Vec2(slope(in.x()) * (p10 - p00 + v * twist),
                          slope(in.y()) * (p01 - p00 + u * twist))};
}

// Returns the centroid of the polygon of a bubble's junctions, in foam units. On a torus, the
// centroid belongs to that copy of the bubble whose first junction is at its stored position. If
// the polygon has no area, for example if the bubble has two sides, returns the mean of the
// junctions.
Vec2 centroid_of(const Frame& frame, BubbleId bubble) {
    constexpr double kNoArea = 1e-6;
    Vec2 at = Vec2::Zero();  // relative to the first junction
    Vec2 sum = Vec2::Zero();
    Vec2 weighted = Vec2::Zero();
    double area = 0.0;  // twice the area
    int count = 0;
    Vec2 first = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        if (count == 0) {
            first = frame.positions[frame.network.tail(h)];
        }
        const Vec2 next = at + frame.arc(h).chord;
        const double twice_triangle = cross(at, next);
        area += twice_triangle;
        weighted += twice_triangle * (at + next);
        sum += at;
        at = next;
        ++count;
    }
    return std::abs(area) > kNoArea ? Vec2(first + weighted / (3.0 * area))
                                    : Vec2(first + sum / count);
}

std::uint32_t seed_of(BubbleIdentity identity, GrainUse use) {
    const auto number = static_cast<std::uint32_t>(identity);
    return scrambled(2U * number + static_cast<std::uint32_t>(use)) | 1U;
}

// Returns the number of octaves of a grain. `size` is the size of its largest features in pixels.
int octaves_of(double size) {
    int octaves = 1;
    while (octaves < kMaxOctaves && 0.5 * size >= kSmallestFeature) {
        size *= 0.5;
        ++octaves;
    }
    return octaves;
}

// The result of a division of integers: the quotient, rounded to nearest, and the remainder, whose
// magnitude is therefore at most half of the divisor.
struct Nearest {
    std::int32_t rest;
    std::int32_t quotient;
};

// Divides n by d. Precondition: d > 0.
Nearest nearest(std::int32_t n, std::int32_t d) {
    const std::int32_t quotient = floor_div(n + d / 2, d);
    return {n - quotient * d, quotient};
}

}  // namespace

GrainValue octave_noise(const Vec2& point, std::uint32_t seed, int octaves) {
    GrainValue sum;
    double size = 1.0;
    for (int k = 0; k < octaves; ++k) {
        const GrainValue one =
            gradient_noise(point / size, seed + static_cast<std::uint32_t>(k) * 0x9e3779b9U);
        sum.value += kScale * size * one.value;
        sum.gradient += kScale * one.gradient;
        size *= 0.5;
    }
    return sum;
}

Grain::Grain(FrameLayers& layers, double size, GrainUse use, double mean)
    : grid_(layers.grid()),
      is_periodic_(!layers.frame().domain.is_plane()),
      size_(diameters_in_pixels(size, layers.grid(), layers.frame().domain)),
      octaves_(octaves_of(size_)),
      mean_(mean),
      ids_(&layers.distance().ids),
      origins_(origins_of(layers, use)) {
    if (is_periodic_) {
        shear_ = shear_in_subpixels(grid_, layers.frame().domain);
    }
}

std::vector<Grain::Origin> Grain::origins_of(FrameLayers& layers, GrainUse use) const {
    const Frame& frame = layers.frame();
    const auto place = [&](const Vec2& center) {
        if (!is_periodic_) {
            return to_subpixel(pixel_in_view(grid_, center));
        }
        const Domain& domain = frame.domain;
        return Snap(grid_, domain)(center - domain.translation(domain.cell_of(center)));
    };
    const auto origins = per_bubble<Origin>(
        frame,
        [&](BubbleId bubble) {
            return Origin{place(centroid_of(frame, bubble)),
                          seed_of(frame.bubbles[bubble].identity, use)};
        },
        [&](const LoneBubble& bubble) {
            return Origin{place(bubble.center), seed_of(bubble.identity, use)};
        });
    return by_cell_id(layers, origins, Origin{});
}

Vec2 Grain::from_center(std::size_t index, SubpixelPoint center) const {
    const auto width = static_cast<std::size_t>(grid_.width);
    const SubpixelPoint pixel{static_cast<std::int32_t>(index % width) * kSubpixel + kSubpixel / 2,
                              static_cast<std::int32_t>(index / width) * kSubpixel + kSubpixel / 2};
    SubpixelPoint from = pixel - center;
    if (is_periodic_) {
        from = from - shift_of(grid_);
        const Nearest up = nearest(from.y, grid_.height * kSubpixel);
        const Nearest across = nearest(from.x - up.quotient * shear_, grid_.width * kSubpixel);
        from = {across.rest, up.rest};
    }
    return Vec2(from.x, from.y) / kSubpixel;
}

GrainValue Grain::at(std::size_t index) const {
    const Origin& origin = origins_[ids_->samples()[index]];
    if (origin.seed == 0) {
        return {};
    }
    GrainValue value =
        octave_noise(from_center(index, origin.center) / size_, origin.seed, octaves_);
    value.value += mean_;
    value.gradient /= size_;
    return value;
}

}  // namespace foam::texgen
