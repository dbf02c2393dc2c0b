#include "texgen/raster/near_sides.h"

#include "texgen/raster/vector_clones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

// What the floats of a batch may be wrong by, pixels.
constexpr double kMargin = 0.01;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

void NearSides::clear() {
    for (Doubles* column : {&middle_x_,
                            &middle_y_,
                            &direction_x_,
                            &direction_y_,
                            &chord_,
                            &over_chord_,
                            &cosine_,
                            &sine_}) {
        column->clear();
    }
    corner_.clear();
    any_corner_ = false;
}

void NearSides::add(const RegionSide& side) {
    middle_x_.push_back(side.arc.middle.x());
    middle_y_.push_back(side.arc.middle.y());
    direction_x_.push_back(side.arc.direction.x());
    direction_y_.push_back(side.arc.direction.y());
    chord_.push_back(side.arc.chord);
    over_chord_.push_back(1.0 / side.arc.chord);
    cosine_.push_back(side.arc.cosine);
    sine_.push_back(side.arc.sine);
    corner_.push_back(side.corner);
    any_corner_ = any_corner_ || side.corner;
}

void NearSides::measure(double reach, bool gradient, PixelBatch& batch) {
    look_from(batch.middle());
    const double farthest = horizon(reach);
    batch.begin();
    for (std::size_t k = 0; k < size(); ++k) {
        if (!(at_least_[k] <= farthest)) {
            continue;
        }
        if (gradient) {
            batch.add_arc_and_gradient(across(k), tail_line(k), head_line(k));
        } else {
            batch.add_arc(across(k), tail_line(k), head_line(k));
        }
    }
    if (any_corner_) {
        add_corners(farthest, false, batch);
    }
    if (batch.is_unresolved()) {  // a pixel a little out of a sharp corner
        add_corners(kFar, true, batch);
    }
}

// As pencil_at and end_normals_at (field_arc.h). A point behind an end is at least as far from the
// arc as from the line there.
FOAMTEX_VECTOR_CLONES void NearSides::look_from(const Vec2& point) {
    const std::size_t count = size();
    for (Doubles* column :
         {&twice_, &slope_x_, &slope_y_, &past_tail_, &before_head_, &at_least_, &facing_}) {
        column->resize(count);
    }
    const double x = point.x();
    const double y = point.y();
    for (std::size_t k = 0; k < count; ++k) {
        const double qx = x - middle_x_[k];
        const double qy = y - middle_y_[k];
        const double along = qx * direction_x_[k] + qy * direction_y_[k];
        const double left = qy * direction_x_[k] - qx * direction_y_[k];
        const double bend = 2.0 * over_chord_[k] * sine_[k];
        const double e = 0.25 * chord_[k] - (qx * qx + qy * qy) * over_chord_[k];
        const double reach = 0.5 * chord_[k] * cosine_[k] - sine_[k] * left;
        twice_[k] = 2.0 * (sine_[k] * e + cosine_[k] * left);
        slope_x_[k] = -bend * qx - cosine_[k] * direction_y_[k];
        slope_y_[k] = -bend * qy + cosine_[k] * direction_x_[k];
        past_tail_[k] = reach + cosine_[k] * along;
        before_head_[k] = reach - cosine_[k] * along;
    }
    const double far = kFar;
    for (std::size_t k = 0; k < count; ++k) {
        const double length = std::sqrt(slope_x_[k] * slope_x_[k] + slope_y_[k] * slope_y_[k]);
        const double distance = std::abs(twice_[k]) / (1.0 + length);
        const double end = past_tail_[k] < before_head_[k] ? past_tail_[k] : before_head_[k];
        facing_[k] = end >= 0.0 ? distance : far;
        at_least_[k] = distance > -end ? distance : -end;
    }
}

double NearSides::horizon(double reach) const {
    double nearest = kFar;
    for (const double distance : facing_) {
        nearest = std::min(nearest, distance);
    }
    return nearest + 2.0 * reach + kMargin;
}

FloatQuadratic NearSides::across(std::size_t k) const {
    return {static_cast<float>(twice_[k]),
            static_cast<float>(slope_x_[k]),
            static_cast<float>(slope_y_[k]),
            static_cast<float>(2.0 * over_chord_[k] * sine_[k])};
}

FloatLine NearSides::tail_line(std::size_t k) const {
    return {static_cast<float>(past_tail_[k]),
            static_cast<float>(cosine_[k] * direction_x_[k] + sine_[k] * direction_y_[k]),
            static_cast<float>(cosine_[k] * direction_y_[k] - sine_[k] * direction_x_[k])};
}

FloatLine NearSides::head_line(std::size_t k) const {
    return {static_cast<float>(before_head_[k]),
            static_cast<float>(sine_[k] * direction_y_[k] - cosine_[k] * direction_x_[k]),
            static_cast<float>(-sine_[k] * direction_x_[k] - cosine_[k] * direction_y_[k])};
}

Vec2 NearSides::end(std::size_t k, double sign) const {
    const double half = 0.5 * sign * chord_[k];
    return {middle_x_[k] + half * direction_x_[k], middle_y_[k] + half * direction_y_[k]};
}

void NearSides::add_corners(double farthest, bool all, PixelBatch& batch) const {
    for (std::size_t k = 0; k < size(); ++k) {
        if (!(at_least_[k] <= farthest)) {
            continue;
        }
        if (all || corner_[k]) {
            batch.add_point(end(k, -1.0) - batch.middle());
        }
        if (all) {
            batch.add_point(end(k, 1.0) - batch.middle());
        }
    }
}

}  // namespace foam::texgen
