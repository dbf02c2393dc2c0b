#include "texgen/raster/distance_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

constexpr int kSide = DistanceTile::kSide;
constexpr float kFar = std::numeric_limits<float>::infinity();
// Pixels that are so little past the end of an arc still face it, so that rounding leaves no gap
// where two arcs go on smoothly.
constexpr float kPastEnd = 1e-3F;
// Squares of distances below this, of pixels, count as this: their inverse has to be a float.
constexpr float kLeastSquare = 1e-12F;
// At an end of a film, where 0 over 0 would come up.
constexpr float kLeastRoot = 1e-18F;
// Sums below this have lost all films: that of a smooth distance of a million pixels.
constexpr float kLeastSum = 1e-12F;

// A Quadratic as a row of pixels needs it.
struct RowForm {
    float value;  // twice, where the row crosses the middle column
    float slope;
    float y_slope;
    float curvature;

    RowForm(const Quadratic& q, float y)
        : slope(static_cast<float>(q.gradient.x())), curvature(static_cast<float>(q.curvature)) {
        const auto middle_slope = static_cast<float>(q.gradient.y());
        y_slope = middle_slope - curvature * y;
        value = 2.0F * static_cast<float>(q.value) + y * (middle_slope + y_slope);
    }
    float x_slope(float x) const { return slope - curvature * x; }
    float twice(float x, float x_slope_there) const { return value + x * (slope + x_slope_there); }
};

float offset(int k) {
    return static_cast<float>(k) - 0.5F * (kSide - 1);
}

}  // namespace

void DistanceTile::reset(std::uint8_t rows) {
    rows_ = rows;
    distance_.fill(kFar);
    gradient_x_.fill(0.0F);
    gradient_y_.fill(0.0F);
    smooth_.fill(0.0F);
    smooth_x_.fill(0.0F);
    smooth_y_.fill(0.0F);
}

void DistanceTile::add_arc(const Quadratic& across, const EndNormals& ends) {
    for (int row = 0; row < kSide; ++row) {
        if (!is_wanted(row)) {
            continue;
        }
        const float y = offset(row);
        const RowForm f(across, y);
        const RowForm tail(ends.tail, y);
        const RowForm head(ends.head, y);
        const auto begin = static_cast<std::size_t>(row) * kSide;
        float* distances = &distance_[begin];
        float* gradients_x = &gradient_x_[begin];
        float* gradients_y = &gradient_y_[begin];
        for (int k = 0; k < kSide; ++k) {
            const float x = offset(k);
            const float slope = f.x_slope(x);
            const float twice = f.twice(x, slope);
            const float length = std::sqrt(slope * slope + f.y_slope * f.y_slope);
            const float distance = std::abs(twice) / (1.0F + length);
            const float past_tail = tail.value + 2.0F * x * tail.slope;
            const float before_head = head.value + 2.0F * x * head.slope;
            const bool faces = std::min(past_tail, before_head) >= -2.0F * kPastEnd;
            const bool nearest = faces & (distance < distances[k]);
            const float sign = std::copysign(1.0F, twice);
            distances[k] = nearest ? distance : distances[k];
            gradients_x[k] = nearest ? sign * slope : gradients_x[k];
            gradients_y[k] = nearest ? sign * f.y_slope : gradients_y[k];
        }
    }
}

void DistanceTile::add_point(const Vec2& point) {
    const auto point_x = static_cast<float>(point.x());
    const auto point_y = static_cast<float>(point.y());
    for (int row = 0; row < kSide; ++row) {
        const float y = offset(row) - point_y;
        const auto begin = static_cast<std::size_t>(row) * kSide;
        for (int k = 0; k < kSide; ++k) {
            const float x = offset(k) - point_x;
            const float distance = std::sqrt(x * x + y * y);
            const std::size_t at = begin + static_cast<std::size_t>(k);
            const bool nearest = distance < distance_[at];
            distance_[at] = nearest ? distance : distance_[at];
            gradient_x_[at] = nearest ? x : gradient_x_[at];
            gradient_y_[at] = nearest ? y : gradient_y_[at];
        }
    }
}

bool DistanceTile::is_unresolved() const {
    for (int row = 0; row < kSide; ++row) {
        const float* distances = &distance_[static_cast<std::size_t>(row) * kSide];
        if (is_wanted(row) && *std::max_element(distances, distances + kSide) == kFar) {
            return true;
        }
    }
    return false;
}

void DistanceTile::normalize_gradients() {
    for (std::size_t k = 0; k < gradient_x_.size(); ++k) {
        const float x = gradient_x_[k];
        const float y = gradient_y_[k];
        const float length = std::sqrt(x * x + y * y);
        const float scale = length > 0.0F ? 1.0F / length : 0.0F;
        gradient_x_[k] = scale * x;
        gradient_y_[k] = scale * y;
    }
}

// phi² = f² + r², r = (root - t) / 2, root = sqrt(t² + f^4 / c²), f being the function across the
// film, t the one along it, c its chord; r grad r = r (f³ / c² grad f - r grad t) / root.
void DistanceTile::add_film(const Pencil& pencil, double chord) {
    const auto over_chord = static_cast<float>(1.0 / chord);
    for (int row = 0; row < kSide; ++row) {
        if (!is_wanted(row)) {
            continue;
        }
        const float y = offset(row);
        const RowForm across(pencil.across, y);
        const RowForm along(pencil.along, y);
        const auto begin = static_cast<std::size_t>(row) * kSide;
        for (int k = 0; k < kSide; ++k) {
            const float x = offset(k);
            const float fx = across.x_slope(x);
            const float tx = along.x_slope(x);
            const float f = 0.5F * across.twice(x, fx);
            const float t = 0.5F * along.twice(x, tx);
            const float bend = f * f * over_chord;
            const float root = std::max(std::sqrt(t * t + bend * bend), kLeastRoot);
            const float sum = root + std::abs(t);
            const float r = t > 0.0F ? 0.5F * bend * (bend / sum) : 0.5F * sum;
            const float square = std::max(f * f + r * r, kLeastSquare);
            const float weight = 1.0F / square;
            const float part = r / root;  // at most 1
            const float from_f = f + part * (f * over_chord) * bend;
            const float from_t = -part * r;
            const float scale = weight / square;
            const std::size_t at = begin + static_cast<std::size_t>(k);
            smooth_[at] += weight;
            smooth_x_[at] += scale * (from_f * fx + from_t * tx);
            smooth_y_[at] += scale * (from_f * across.y_slope + from_t * along.y_slope);
        }
    }
}

// s = S^-1/2, and grad s = s³ sum of phi^-4 (f grad f + r grad r).
void DistanceTile::finish_smooth() {
    for (std::size_t k = 0; k < smooth_.size(); ++k) {
        const float s = 1.0F / std::sqrt(smooth_[k]);
        const float scale = s * s * s;
        const bool lost = !(smooth_[k] > kLeastSum);
        smooth_[k] = lost ? distance_[k] : s;
        smooth_x_[k] = lost ? gradient_x_[k] : scale * smooth_x_[k];
        smooth_y_[k] = lost ? gradient_y_[k] : scale * smooth_y_[k];
    }
}

}  // namespace foam::texgen
