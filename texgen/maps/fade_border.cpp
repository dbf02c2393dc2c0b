// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/fade_border.h"

#include "texgen/maps/arcs_of_films.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// In a cross-fade, bubbles of the new foam grow over the old foam (fade_border.h). The growth of a
// bubble is from 0 (not visible) to 1 (complete). Until it is complete, a growing bubble is bounded
// by its rim: a level set of the smooth distance s from its films (DistanceField::smooth). In a
// circle of radius R, s = (R² - r²) / (2 R) at the distance r from the center. The points where s
// is above h = R/2 (1 - g²) form a circle of radius g R. The smooth distance from the rim of this
// circle is (s - h) / g. The same formulas are used for all bubbles: g is the growth, and R is
// twice the largest smooth distance in the bubble, as in a circle.

namespace foam::texgen {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The border affects the relief of the old foam up to this distance, in units of the square root of
// the mean bubble area. This distance is about the radius of a bubble. Farther away, the distance
// from the border has creases, which would be visible in the relief.
constexpr double kReach = 0.5;

// Before a division by a slope, the slope is clamped to be at least this value.
constexpr double kFlattestRim = 1e-6;

Vec2 vector_at(const Image<float>& image, std::size_t index) {
    const auto pixel = image.samples().subspan(2 * index, 2);
    return {pixel[0], pixel[1]};
}

void set_vector(Image<float>& image, std::size_t index, const Vec2& vector) {
    const auto pixel = image.samples().subspan(2 * index, 2);
    pixel[0] = static_cast<float>(vector.x());
    pixel[1] = static_cast<float>(vector.y());
}

// A distance from films or from the border, and its gradient. The distance from a rim is positive
// inside the growing bubble.
struct DistanceAndGradient {
    double distance = 0.0;
    Vec2 gradient = Vec2::Zero();
};

// Returns the radius R of every bubble (see the top of this file) in pixels, indexed by the ids of
// the distance field.
std::vector<double> radii_of(const DistanceField& field, std::size_t bubbles) {
    std::vector<double> radii(bubbles, 0.0);
    for (std::size_t k = 0; k < field.ids.samples().size(); ++k) {
        double& radius = radii[field.ids.samples()[k]];
        radius = std::max(radius, 2.0 * static_cast<double>(field.smooth.samples()[k]));
    }
    return radii;
}

// Returns the signed distance from the rim of a circle of radius `rim`. `smooth` is the smooth
// distance from the rim, (rim² - r²) / (2 rim), and the gradient of this smooth distance. For other
// shapes, the result is correct only to first order near the rim.
DistanceAndGradient from_rim(const DistanceAndGradient& smooth, double rim) {
    const double slope = std::max(std::sqrt(smooth.gradient.squaredNorm()), kFlattestRim);
    const double first_order = smooth.distance / slope;
    const double root = std::sqrt(first_order * first_order + rim * rim);
    const double distance = first_order > 0.0 ? 2.0 * rim * first_order / (rim + first_order + root)
                                              : rim + first_order - root;
    return {distance, smooth.gradient / slope};
}

// Joins the smooth distance s from films with the distance d from the border. The result r
// satisfies 1/r² = 1/s² + 1/d². Its gradient is (r/s)³ times the gradient of s plus (r/d)³ times
// the gradient of d.
DistanceAndGradient with_border(const DistanceAndGradient& films,
                                const DistanceAndGradient& border) {
    const double s = films.distance;
    const double d = border.distance;
    if (std::isinf(d) || s == 0.0) {
        return films;
    }
    const double root = std::sqrt(s * s + d * d);
    const double r_by_s = d / root;
    const double r_by_d = s / root;
    return {s * r_by_s,
            r_by_s * r_by_s * r_by_s * films.gradient + r_by_d * r_by_d * r_by_d * border.gradient};
}

// Returns a distance that is close to the given distance near 0 and infinite beyond the reach:
// 1 / result = 1 / distance - 1 / reach.
DistanceAndGradient limited(const DistanceAndGradient& border, double reach) {
    if (!(border.distance < reach)) {
        return {std::numeric_limits<double>::infinity(), Vec2::Zero()};
    }
    const double factor = reach / (reach - border.distance);
    return {factor * border.distance, factor * factor * border.gradient};
}

// Returns kReach in pixels.
double reach_of(const CrossFade& fade, const RasterGrid& grid) {
    const double area = static_cast<double>(grid.width) * grid.height;
    return kReach * std::sqrt(area / static_cast<double>(fade.fading_in.bubbles.size()));
}

// Returns the distances from the films between complete bubbles and bubbles that are not complete.
ArcDistances distances_to_border_films(const CrossFade& fade, const RasterGrid& grid, int threads) {
    const Frame& frame = fade.fading_in;
    const auto is_complete = [&](BubbleId bubble) { return fade.growth[index_of(bubble)] == 1.0; };
    const std::vector<PlacedArc> films = arcs_of_films(frame, grid, threads, [&](FilmId film) {
        const HalfEdgeId side = forward_side(film);
        return is_complete(frame.network.left(side)) != is_complete(frame.network.right(side));
    });
    return distances_to_arcs(
        films, grid, frame.domain, {.reach = reach_of(fade, grid), .gradient = true}, threads);
}

// Joins the distance fields `out` (of the old foam) and `in` (of the new foam) pixel by pixel.
// Afterwards both contain the same distances: from the films of the foam that is shown at the
// pixel, or from the border if the border is nearer.
class FieldJoiner {
  public:
    FieldJoiner(const CrossFade& fade,
                const ArcDistances& films,
                double reach,
                DistanceField& out,
                DistanceField& in)
        : growth_(fade.growth),
          reach_(reach),
          films_(films),
          out_(out),
          in_(in),
          radii_(radii_of(in, fade.fading_in.bubbles.size())) {}

    // Joins both fields at a pixel, and sets FadeBorder::distance and FadeBorder::weights there.
    void join(std::size_t k, FadeBorder& border) {
        DistanceAndGradient nearest{static_cast<double>(films_.distance.samples()[k]),
                                    vector_at(films_.gradient, k)};
        const std::size_t bubble = in_.ids.samples()[k];
        bool shows_new = growth_[bubble] == 1.0;
        float& distance = border.distance.samples()[k];
        if (shows_new) {
            copy(k, in_, out_);
            distance = kInfinity;
        } else {
            shows_new = growth_[bubble] > 0.0 && join_growing(k, bubble, nearest);
            if (!shows_new) {
                show_old(k, nearest);
            }
            distance = static_cast<float>(shows_new ? nearest.distance : -nearest.distance);
        }
        const double inside = shows_new ? nearest.distance : -nearest.distance;
        border.weights.samples()[k] = static_cast<float>(std::clamp(0.5 + inside, 0.0, 1.0));
    }

  private:
    // If a pixel of a growing bubble is within the rim of the bubble, joins both fields at the
    // pixel and returns true. Otherwise returns false. `nearest` is the distance from the nearest
    // film of the border. If the rim is nearer, the distance from the rim replaces it, even if the
    // pixel is outside the rim.
    bool join_growing(std::size_t k, std::size_t bubble, DistanceAndGradient& nearest) {
        const DistanceAndGradient smooth = smooth_from_rim(k, bubble);
        const DistanceAndGradient rim = from_rim(smooth, growth_[bubble] * radii_[bubble]);
        const bool is_inside = rim.distance > 0.0;
        if (std::abs(rim.distance) < nearest.distance) {
            nearest = is_inside ? rim : DistanceAndGradient{-rim.distance, -rim.gradient};
        }
        if (is_inside) {
            show_growing(k, smooth, nearest);
        }
        return is_inside;
    }

    DistanceAndGradient films_at(const DistanceField& field, std::size_t k) const {
        return {static_cast<double>(field.smooth.samples()[k]),
                vector_at(field.smooth_gradient, k)};
    }

    // Returns the smooth distance from the rim of a growing bubble, negative outside.
    DistanceAndGradient smooth_from_rim(std::size_t k, std::size_t bubble) const {
        const double growth = growth_[bubble];
        const double level = 0.5 * radii_[bubble] * (1.0 - growth * growth);
        const DistanceAndGradient films = films_at(in_, k);
        return {(films.distance - level) / growth, films.gradient / growth};
    }

    void show_growing(std::size_t k,
                      const DistanceAndGradient& smooth,
                      const DistanceAndGradient& border) {
        in_.smooth.samples()[k] = static_cast<float>(smooth.distance);
        set_vector(in_.smooth_gradient, k, smooth.gradient);
        limit_distance(k, in_, border);
        copy(k, in_, out_);
    }

    void show_old(std::size_t k, const DistanceAndGradient& border) {
        const DistanceAndGradient smooth = with_border(films_at(out_, k), limited(border, reach_));
        out_.smooth.samples()[k] = static_cast<float>(smooth.distance);
        set_vector(out_.smooth_gradient, k, smooth.gradient);
        limit_distance(k, out_, border);
        copy(k, out_, in_);
    }

    static void limit_distance(std::size_t k,
                               DistanceField& field,
                               const DistanceAndGradient& border) {
        if (field.distance.samples().empty()) {
            return;
        }
        float& distance = field.distance.samples()[k];
        if (border.distance < static_cast<double>(distance)) {
            distance = static_cast<float>(border.distance);
            if (!field.gradient.samples().empty()) {
                set_vector(field.gradient, k, border.gradient);
            }
        }
    }

    static void copy(std::size_t k, const DistanceField& from, DistanceField& to) {
        if (!from.distance.samples().empty()) {
            to.distance.samples()[k] = from.distance.samples()[k];
        }
        to.smooth.samples()[k] = from.smooth.samples()[k];
        set_vector(to.smooth_gradient, k, vector_at(from.smooth_gradient, k));
        if (!from.gradient.samples().empty()) {
            set_vector(to.gradient, k, vector_at(from.gradient, k));
        }
    }

    std::span<const double> growth_;
    double reach_;
    const ArcDistances& films_;
    DistanceField& out_;
    DistanceField& in_;
    std::vector<double> radii_;
};

}  // namespace

FadeBorder join_at_border(const CrossFade& fade,
                          const RasterGrid& grid,
                          int threads,
                          DistanceField& out,
                          DistanceField& in) {
    const ArcDistances films = distances_to_border_films(fade, grid, threads);
    FieldJoiner joiner(fade, films, reach_of(fade, grid), out, in);
    FadeBorder border{{grid.width, grid.height, 1}, {grid.width, grid.height, 1}};
    for (std::size_t k = 0; k < border.distance.samples().size(); ++k) {
        joiner.join(k, border);
    }
    return border;
}

float line_coverage(double distance, double width) {
    const double inner = std::max(-0.5, std::abs(distance) - 0.5 * width);
    const double outer = std::min(0.5, std::abs(distance) + 0.5 * width);
    return static_cast<float>(std::clamp(outer - inner, 0.0, 1.0));
}

}  // namespace foam::texgen
