#include "core/geometry/film_arc.h"

#include <array>
#include <cmath>

namespace foam {

namespace {

// Below this the closed forms lose more than the series do; 14 terms then leave less than 1e-17.
constexpr double kSeriesLimit = 0.25;
constexpr int kSeriesTerms = 14;

// 1/sqrt(1 - s²) = sum over k of c_k s^2k.
constexpr std::array<double, kSeriesTerms> central_coefficients() {
    std::array<double, kSeriesTerms> c{};
    c[0] = 1.0;
    for (int k = 1; k < kSeriesTerms; ++k) {
        c[static_cast<std::size_t>(k)] =
            c[static_cast<std::size_t>(k - 1)] * (2.0 * k - 1.0) / (2.0 * k);
    }
    return c;
}

// Sum over k of weight(k) c_k s^2k, by Horner's rule.
template <class Weight>
double even_series(double s, Weight weight) {
    static constexpr auto kCentral = central_coefficients();
    double sum = 0.0;
    for (int k = kSeriesTerms - 1; k >= 0; --k) {
        sum = sum * s * s + weight(k) * kCentral[static_cast<std::size_t>(k)];
    }
    return sum;
}

Vec2 rotated(const Vec2& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

double angle_over_sine(double angle) {
    return angle == 0.0 ? 1.0 : angle / std::sin(angle);
}

// (alpha - sin alpha cos alpha) / sin² alpha on the whole range of half angles.
double segment_shape_of_angle(double half_angle) {
    const double s = std::sin(half_angle);
    const double c = std::cos(half_angle);
    if (c > 0.0 && std::abs(s) < kSeriesLimit) {
        return segment_shape(s);
    }
    return (half_angle - s * c) / (s * s);  // not from s alone, whose asin is ill-conditioned at 90
}

}  // namespace

double segment_shape(double s) {
    if (std::abs(s) < kSeriesLimit) {
        return s * even_series(s, [](int k) { return 2.0 / (2 * k + 3); });
    }
    return (std::asin(s) - s * std::sqrt((1.0 - s) * (1.0 + s))) / (s * s);
}

double segment_shape_slope(double s) {
    if (std::abs(s) < kSeriesLimit) {
        return even_series(s, [](int k) { return 2.0 * (2 * k + 1) / (2 * k + 3); });
    }
    return 2.0 / std::sqrt((1.0 - s) * (1.0 + s)) - 2.0 * segment_shape(s) / s;
}

double arc_length(const FilmArc& arc) {
    return arc.chord.norm() * angle_over_sine(arc.half_angle);
}

double segment_area(const FilmArc& arc) {
    return 0.25 * arc.chord.squaredNorm() * segment_shape_of_angle(arc.half_angle);
}

double curvature(const FilmArc& arc) {
    const double c = arc.chord.norm();
    return c == 0.0 ? 0.0 : 2.0 * std::sin(arc.half_angle) / c;
}

Vec2 tangent_at_tail(const FilmArc& arc) {
    return rotated(arc.chord.normalized(), -arc.half_angle);
}

Vec2 tangent_at_head(const FilmArc& arc) {
    return rotated(arc.chord.normalized(), arc.half_angle);
}

Vec2 point_at(const FilmArc& arc, double fraction) {
    // The chord from the tail to the point makes the angle (fraction - 1) alpha with the whole
    // chord.
    const double scale =
        fraction * angle_over_sine(arc.half_angle) / angle_over_sine(fraction * arc.half_angle);
    return scale * rotated(arc.chord, (fraction - 1.0) * arc.half_angle);
}

}  // namespace foam
