// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/grain.h"

#include "core/parallel/parallel_for.h"
#include "core/parallel/simd_level.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/gradient_noise.h"
#include "texgen/maps/per_bubble.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

// The grain is fractal noise: octaves of gradient noise (K. Perlin, "Improving noise", 2002), each
// with half the size and half the height of the preceding one. Octaves that the pixels cannot
// resolve, except the first one, are left out, which prevents aliasing (A. Norton, A. P. Rockwood
// and P. T. Skolmoski, "Clamping: a method of antialiasing textured surfaces by bandwidth limiting
// in object space", 1982). The origin of the noise in a bubble is its centroid, rounded to
// subpixels. Positions relative to it are whole numbers of subpixels, so that a shift of the grid
// shifts the grain without changing a bit. To place the origins at the centroids is our own idea.

namespace foam::texgen {

namespace {

constexpr int kMaxOctaves = 5;
// The smallest size of features in pixels. Octaves with smaller features are left out, except the
// first octave.
constexpr double kSmallestFeature = 2.0;

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

// The origin and the seed of the noise in each bubble, indexed by the ids of the distance field.
// Origins are whole numbers, but are stored as doubles, because the origins in a magnified patch
// may not fit into 32 bits.
struct Origins {
    // The centroids of the bubbles, in subpixels, on the unshifted grid (RasterGrid::shift_x).
    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::uint32_t> seeds;  // 0 around a patch
};

Origins origins_of(const Frame& frame, const RasterGrid& grid, GrainUse use) {
    const Domain& domain = frame.domain;
    const auto position = [&](const Vec2& center) {
        if (domain.is_plane()) {
            return rounded_to_subpixels(pixel_in_view(grid, center));
        }
        const Vec2 wrapped = center - domain.translation(domain.cell_of(center));
        const SubpixelPoint rounded = Snap(grid, domain)(wrapped);
        return Vec2(rounded.x, rounded.y);
    };
    const auto centers = per_bubble<Vec2>(
        frame,
        [&](BubbleId bubble) { return position(centroid_of(frame, bubble)); },
        [&](const LoneBubble& bubble) { return position(bubble.center); });
    const auto seeds = per_bubble<std::uint32_t>(
        frame,
        [&](BubbleId bubble) { return seed_of_grain(frame.bubbles[bubble].identity, use); },
        [&](const LoneBubble& bubble) { return seed_of_grain(bubble.identity, use); });
    Origins origins;
    for (const Vec2& center : by_cell_id(frame, centers, Vec2(0.0, 0.0))) {
        origins.x.push_back(center.x());
        origins.y.push_back(center.y());
    }
    origins.seeds = by_cell_id(frame, seeds, std::uint32_t{0});
    return origins;
}

// The periods of a grid, in subpixels: whole numbers. In the plane, they are so large that nothing
// is wrapped.
struct Periods {
    double width;
    double height;
    double shear;
};

Periods periods_of(const RasterGrid& grid, const Domain& domain) {
    if (domain.is_plane()) {
        constexpr double kNoPeriod = 0x1p60;
        return {kNoPeriod, kNoPeriod, 0.0};
    }
    return {static_cast<double>(grid.width * kSubpixel),
            static_cast<double>(grid.height * kSubpixel),
            static_cast<double>(shear_in_subpixels(grid, domain))};
}

// Returns the number of periods in a distance, rounded to nearest. On a torus, distances and
// periods are whole numbers. A quotient that is not an integer therefore differs from every integer
// by at least 1 / period. This is far more than its rounding error, so rounding errors do not
// change the result.
double periods_in(double distance, double period) {
    return floor_of((distance + 0.5 * period) / period);
}

// The points of the noise at the pixels of a row. `x` and `y` are the center of a pixel relative to
// the centroid of its bubble. They are in units of the size of the largest features, that is, of
// the features of the first octave. `seeds` are the seeds of the noise in the bubbles.
struct RowPoints {
    explicit RowPoints(std::size_t width) : x(width), y(width), seeds(width) {}

    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::uint32_t> seeds;
};

// The values that all rows of an image share.
struct GrainPlan {
    Origins origins;
    Periods periods{};
    SubpixelPoint shift;  // RasterGrid::shift_x and shift_y; 0 in the plane
    double size = 0.0;    // size of the largest features, in pixels
};

// Sets the points of the row `y`.
void set_points(const GrainPlan& plan,
                std::span<const std::uint32_t> ids,
                int y,
                RowPoints& points) {
    at_simd_level([count = ids.size(),
                   ids = ids.data(),
                   origins_x = plan.origins.x.data(),
                   origins_y = plan.origins.y.data(),
                   seeds = plan.origins.seeds.data(),
                   periods = plan.periods,
                   left = kSubpixel / 2 - plan.shift.x,
                   bottom = y * kSubpixel + kSubpixel / 2 - plan.shift.y,
                   scale = 1.0 / (plan.size * kSubpixel),
                   to_x = points.x.data(),
                   to_y = points.y.data(),
                   to_seeds = points.seeds.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t id = ids[k];
            const double from_y = bottom - origins_y[id];
            const double periods_up = periods_in(from_y, periods.height);
            const double from_x = static_cast<std::int32_t>(k) * kSubpixel + left - origins_x[id] -
                                  periods_up * periods.shear;
            const double periods_across = periods_in(from_x, periods.width);
            to_x[k] = scale * (from_x - periods_across * periods.width);
            to_y[k] = scale * (from_y - periods_up * periods.height);
            to_seeds[k] = seeds[id];
        }
    });
}

// The pixels of a row of a Grain to which an octave of noise is added.
struct OctaveTarget {
    std::span<float> value;
    float* slope_x;  // null if only values are drawn
    float* slope_y;
    double height;     // factor on the values of the noise
    double steepness;  // factor on its slopes
};

// Adds one octave of noise to a row of pixels. `octave` is the number of the octave (the first is
// 0).
template <bool kSlopes>
void add_octave(const RowPoints& points, int octave, const OctaveTarget& target) {
    at_simd_level([xs = points.x.data(),
                   ys = points.y.data(),
                   seeds = points.seeds.data(),
                   added_to_seed = seed_of_octave(0, octave),
                   frequency = static_cast<double>(1U << static_cast<unsigned>(octave)),
                   value = target.value.data(),
                   to = target] {
        for (std::size_t k = 0; k < to.value.size(); ++k) {
            const NoiseValue noise =
                gradient_noise(frequency * xs[k], frequency * ys[k], seeds[k] + added_to_seed);
            const bool is_inside = seeds[k] != 0;
            value[k] += static_cast<float>(is_inside ? to.height * noise.value : 0.0);
            if constexpr (kSlopes) {
                to.slope_x[k] += static_cast<float>(is_inside ? to.steepness * noise.slope_x : 0.0);
                to.slope_y[k] += static_cast<float>(is_inside ? to.steepness * noise.slope_y : 0.0);
            }
        }
    });
}

}  // namespace

std::uint32_t seed_of_grain(BubbleIdentity identity, GrainUse use) {
    const auto number = static_cast<std::uint32_t>(identity);
    return scrambled(2U * number + static_cast<std::uint32_t>(use)) | 1U;
}

Grain draw_grain(const Frame& frame,
                 const RasterGrid& grid,
                 const Image<std::uint32_t>& ids,
                 const GrainRule& rule,
                 GrainImages images,
                 int threads) {
    const double pixels = diameters_in_pixels(rule.size, grid, frame.domain);
    const GrainPlan plan{
        origins_of(frame, grid, rule.use),
        periods_of(grid, frame.domain),
        frame.domain.is_plane() ? SubpixelPoint{} : shift_of(grid),
        pixels,
    };
    const bool has_slopes = images == GrainImages::ValuesAndSlopes;
    const auto image_if = [&](bool is_drawn) {
        return is_drawn ? Image<float>(grid.width, grid.height, 1) : Image<float>();
    };
    Grain grain{image_if(true), image_if(has_slopes), image_if(has_slopes)};
    const int octaves = octaves_of(pixels);
    std::vector<RowPoints> workers(static_cast<std::size_t>(thread_count(threads)),
                                   RowPoints(static_cast<std::size_t>(grid.width)));
    parallel_for(grid.height, workers, [&](RowPoints& points, int y) {
        set_points(plan, ids.row(y), y, points);
        OctaveTarget target{grain.value.row(y),
                            has_slopes ? grain.slope_x.row(y).data() : nullptr,
                            has_slopes ? grain.slope_y.row(y).data() : nullptr,
                            kNoiseScale,
                            kNoiseScale / pixels};
        for (std::size_t k = 0; k < target.value.size(); ++k) {
            target.value[k] = points.seeds[k] == 0 ? 0.0F : static_cast<float>(rule.mean);
        }
        const auto add = has_slopes ? add_octave<true> : add_octave<false>;
        for (int octave = 0; octave < octaves; ++octave) {
            add(points, octave, target);
            target.height *= 0.5;
        }
    });
    return grain;
}

}  // namespace foam::texgen
