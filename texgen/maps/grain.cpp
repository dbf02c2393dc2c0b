// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/grain.h"

#include "core/parallel/simd_level.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

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

// The unit gradients of lattice points: 16 directions, 22.5 degrees apart. kA and kB are the cosine
// and the sine of 22.5 degrees, kC is the cosine of 45 degrees.
constexpr double kA = 0.9238795325112867;
constexpr double kB = 0.3826834323650898;
constexpr double kC = 0.7071067811865476;
constexpr std::array<double, 16> kGradientsX = {
    1, kA, kC, kB, 0, -kB, -kC, -kA, -1, -kA, -kC, -kB, 0, kB, kC, kA};
constexpr std::array<double, 16> kGradientsY = {
    0, kB, kC, kA, 1, kA, kC, kB, 0, -kB, -kC, -kA, -1, -kA, -kC, -kB};

// A plane (a linear function) that is 0 at a lattice point.
struct LatticePlane {
    double value;  // at the point of the noise
    double slope_x;
    double slope_y;
};

// Returns the plane of a lattice point in the row with the given hash. `x` and `y` are the position
// of the point of the noise relative to the lattice point.
LatticePlane plane_of(std::int32_t column, std::uint32_t row, double x, double y) {
    const std::uint32_t direction = scrambled(static_cast<std::uint32_t>(column) + row) >> 28U;
    const double slope_x = kGradientsX.data()[direction];
    const double slope_y = kGradientsY.data()[direction];
    return {slope_x * x + slope_y * y, slope_x, slope_y};
}

// Returns the largest integer that is not above x. Loops that call this function can be vectorized
// on every level. Precondition: the integer fits into 32 bits.
std::int32_t floor_of(double x) {
    const auto towards_zero = static_cast<std::int32_t>(x);
    return towards_zero - (x < towards_zero ? 1 : 0);
}

// Returns gradient noise on the lattice of the points with integer coordinates, so that its
// features have the size 1. Each of the four lattice points around the point defines a plane.
// Quintic polynomials blend the four planes.
NoiseValue gradient_noise(double x, double y, std::uint32_t seed) {
    const std::int32_t column = floor_of(x);
    const std::int32_t line = floor_of(y);
    const double in_x = x - column;
    const double in_y = y - line;
    const auto blend = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
    const auto slope = [](double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); };
    const double u = blend(in_x);
    const double v = blend(in_y);
    const std::uint32_t lower = row_hash(line, seed);
    const std::uint32_t upper = row_hash(line + 1, seed);
    const LatticePlane p00 = plane_of(column, lower, in_x, in_y);
    const LatticePlane p10 = plane_of(column + 1, lower, in_x - 1.0, in_y);
    const LatticePlane p01 = plane_of(column, upper, in_x, in_y - 1.0);
    const LatticePlane p11 = plane_of(column + 1, upper, in_x - 1.0, in_y - 1.0);
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

std::uint32_t seed_of_octave(std::uint32_t seed, int octave) {
    return seed + static_cast<std::uint32_t>(octave) * 0x9e3779b9U;
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

// Returns the number of octaves of a grain. `size` is the size of its largest features in pixels.
int octaves_of(double size) {
    int octaves = 1;
    while (octaves < kMaxOctaves && 0.5 * size >= kSmallestFeature) {
        size *= 0.5;
        ++octaves;
    }
    return octaves;
}

// The grains of the bubbles, indexed by the ids of the distance field.
struct Origins {
    std::vector<std::int32_t> x;  // the centroid of the bubble on the unshifted grid, in subpixels
    std::vector<std::int32_t> y;
    std::vector<std::uint32_t> seeds;  // 0 around a patch
};

Origins origins_of(FrameLayers& layers, GrainUse use) {
    const Frame& frame = layers.frame();
    const Domain& domain = frame.domain;
    const auto position = [&](const Vec2& center) {
        return domain.is_plane() ? to_subpixel(pixel_in_view(layers.grid(), center))
                                 : Snap(layers.grid(), domain)(
                                       center - domain.translation(domain.cell_of(center)));
    };
    const auto centers = per_bubble<SubpixelPoint>(
        frame,
        [&](BubbleId bubble) { return position(centroid_of(frame, bubble)); },
        [&](const LoneBubble& bubble) { return position(bubble.center); });
    const auto seeds = per_bubble<std::uint32_t>(
        frame,
        [&](BubbleId bubble) { return seed_of_grain(frame.bubbles[bubble].identity, use); },
        [&](const LoneBubble& bubble) { return seed_of_grain(bubble.identity, use); });
    Origins origins;
    for (const SubpixelPoint& center : by_cell_id(layers, centers, SubpixelPoint{})) {
        origins.x.push_back(center.x);
        origins.y.push_back(center.y);
    }
    origins.seeds = by_cell_id(layers, seeds, std::uint32_t{0});
    return origins;
}

// The periods of a grid, in subpixels. In the plane, they are so large that nothing is wrapped.
struct Periods {
    std::int32_t width;
    std::int32_t height;
    std::int32_t shear;
};

Periods periods_of(const RasterGrid& grid, const Domain& domain) {
    if (domain.is_plane()) {
        constexpr std::int32_t kNoPeriod = std::numeric_limits<std::int32_t>::max();
        return {kNoPeriod, kNoPeriod, 0};
    }
    return {grid.width * kSubpixel, grid.height * kSubpixel, shear_in_subpixels(grid, domain)};
}

// Returns the number of periods in a distance, rounded to nearest. The quotient is exact: a double
// represents it well enough to distinguish it from the next integer.
std::int32_t periods_in(std::int32_t distance, std::int32_t period) {
    return floor_of((static_cast<double>(distance) + period / 2) / period);
}

// The points of the noise in a row of pixels, relative to the centroids of their bubbles, in
// features of the first octave.
struct RowPoints {
    explicit RowPoints(std::size_t width) : x(width), y(width), seeds(width) {}

    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::uint32_t> seeds;
};

// Sets the points of the row `y`.
void set_points(const FrameLayers& layers,
                std::span<const std::uint32_t> ids,
                const Origins& origins,
                double size,
                int y,
                RowPoints& points) {
    const bool is_plane = layers.is_patch();
    const SubpixelPoint shift = is_plane ? SubpixelPoint{} : shift_of(layers.grid());
    at_simd_level([count = ids.size(),
                   ids = ids.data(),
                   origins_x = origins.x.data(),
                   origins_y = origins.y.data(),
                   seeds = origins.seeds.data(),
                   periods = periods_of(layers.grid(), layers.frame().domain),
                   left = kSubpixel / 2 - shift.x,
                   bottom = y * kSubpixel + kSubpixel / 2 - shift.y,
                   scale = 1.0 / (size * kSubpixel),
                   to_x = points.x.data(),
                   to_y = points.y.data(),
                   to_seeds = points.seeds.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t id = ids[k];
            const std::int32_t from_y = bottom - origins_y[id];
            const std::int32_t up = periods_in(from_y, periods.height);
            const std::int32_t from_x = static_cast<std::int32_t>(k) * kSubpixel + left -
                                        origins_x[id] - up * periods.shear;
            const std::int32_t across = periods_in(from_x, periods.width);
            to_x[k] = scale * (from_x - across * periods.width);
            to_y[k] = scale * (from_y - up * periods.height);
            to_seeds[k] = seeds[id];
        }
    });
}

// The spans of a grain in a row of pixels.
struct GrainRow {
    std::span<float> value;
    std::span<float> slope_x;
    std::span<float> slope_y;
};

// Adds one octave of noise to a row of pixels. `height` is the factor on values, `steepness` the
// factor on slopes, and `frequency` the number of features in a feature of the first octave.
void add_octave(
    const RowPoints& points, int octave, double height, double steepness, const GrainRow& row) {
    at_simd_level([count = row.value.size(),
                   xs = points.x.data(),
                   ys = points.y.data(),
                   seeds = points.seeds.data(),
                   added_to_seed = seed_of_octave(0, octave),
                   frequency = static_cast<double>(1U << static_cast<unsigned>(octave)),
                   height,
                   steepness,
                   value = row.value.data(),
                   slope_x = row.slope_x.data(),
                   slope_y = row.slope_y.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const NoiseValue noise =
                gradient_noise(frequency * xs[k], frequency * ys[k], seeds[k] + added_to_seed);
            const bool is_inside = seeds[k] != 0;
            value[k] += static_cast<float>(is_inside ? height * noise.value : 0.0);
            slope_x[k] += static_cast<float>(is_inside ? steepness * noise.slope_x : 0.0);
            slope_y[k] += static_cast<float>(is_inside ? steepness * noise.slope_y : 0.0);
        }
    });
}

}  // namespace

NoiseValue octave_noise(const Vec2& point, std::uint32_t seed, int octaves) {
    NoiseValue sum;
    double size = 1.0;
    for (int k = 0; k < octaves; ++k) {
        const NoiseValue one =
            gradient_noise(point.x() / size, point.y() / size, seed_of_octave(seed, k));
        sum.value += kScale * size * one.value;
        sum.slope_x += kScale * one.slope_x;
        sum.slope_y += kScale * one.slope_y;
        size *= 0.5;
    }
    return sum;
}

std::uint32_t seed_of_grain(BubbleIdentity identity, GrainUse use) {
    const auto number = static_cast<std::uint32_t>(identity);
    return scrambled(2U * number + static_cast<std::uint32_t>(use)) | 1U;
}

Grain draw_grain(FrameLayers& layers, double size, GrainUse use, double mean) {
    const RasterGrid& grid = layers.grid();
    const double pixels = diameters_in_pixels(size, grid, layers.frame().domain);
    const Image<std::uint32_t>& ids = layers.distance().ids;
    const Origins origins = origins_of(layers, use);
    const auto blank = [&] { return Image<float>(grid.width, grid.height, 1); };
    Grain grain{blank(), blank(), blank()};
    RowPoints points(static_cast<std::size_t>(grid.width));
    for (int y = 0; y < grid.height; ++y) {
        set_points(layers, ids.row(y), origins, pixels, y, points);
        const GrainRow row{grain.value.row(y), grain.slope_x.row(y), grain.slope_y.row(y)};
        for (std::size_t k = 0; k < row.value.size(); ++k) {
            row.value[k] = points.seeds[k] == 0 ? 0.0F : static_cast<float>(mean);
        }
        double height = kScale;
        for (int octave = 0; octave < octaves_of(pixels); ++octave) {
            add_octave(points, octave, height, kScale / pixels, row);
            height *= 0.5;
        }
    }
    return grain;
}

}  // namespace foam::texgen
