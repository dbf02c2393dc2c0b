#include "texgen/raster/distance/arc_lanes.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

void ArcLanes::clear() {
    size_ = 0;
    corner_count_ = 0;
    corners_.clear();
}

void ArcLanes::add(const PixelArc& shape, const Vec2& tail, bool corner) {
    const std::size_t k = size_ % kLanes;
    if (size_ / kLanes == blocks_.size()) {
        blocks_.emplace_back();
    }
    Block& block = blocks_[size_ / kLanes];
    block.tail_x[k] = tail.x();
    block.tail_y[k] = tail.y();
    block.chord_x[k] = shape.chord.x();
    block.chord_y[k] = shape.chord.y();
    block.cosine[k] = shape.cosine;
    block.sine[k] = shape.sine;
    corners_.push_back(corner ? 1 : 0);
    corner_count_ += corner ? 1U : 0U;
    ++size_;
}

void ArcLanes::add(const ArcLanes& other, std::size_t k) {
    add({{other.at(&Block::chord_x, k), other.at(&Block::chord_y, k)},
         other.at(&Block::cosine, k),
         other.at(&Block::sine, k)},
        other.tail(k),
        other.has_corner(k));
}

inline void ArcLanes::find_directions(Block& b, Terms& terms) {
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double chord = std::sqrt(b.chord_x[k] * b.chord_x[k] + b.chord_y[k] * b.chord_y[k]);
        b.chord[k] = chord;
        terms.over_chord[k] = 1.0 / chord;
        terms.direction_x[k] = b.chord_x[k] / chord;
        terms.direction_y[k] = b.chord_y[k] / chord;
    }
}

// Let q be the point seen from the middle of the chord c, e = c/4 - q²/c, which is 0 on the circle
// around the chord, and h the distance of q to the left of the chord: both are 0 at the ends of the
// chord. Turned by the half angle they become f = sin e + cos h, which is 0 on the circle of the
// arc with slope 1, positive on its left, and t = cos e - sin h, which is 0 with slope 1 on the
// circle that cuts the arc off at right angles, positive on the arc.
inline void ArcLanes::find_functions(double x, double y, Block& b, Terms& terms) {
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double direction_x = terms.direction_x[k];
        const double direction_y = terms.direction_y[k];
        const double qx = x - (b.tail_x[k] + 0.5 * b.chord_x[k]);
        const double qy = y - (b.tail_y[k] + 0.5 * b.chord_y[k]);
        const double forward = qx * direction_x + qy * direction_y;
        const double left = qy * direction_x - qx * direction_y;
        const double e = 0.25 * b.chord[k] - (qx * qx + qy * qy) * terms.over_chord[k];
        const double bend = 2.0 * terms.over_chord[k] * b.sine[k];
        const double along_bend = 2.0 * terms.over_chord[k] * b.cosine[k];
        const double reach = 0.5 * b.chord[k] * b.cosine[k] - b.sine[k] * left;
        b.twice[k] = 2.0 * (b.sine[k] * e + b.cosine[k] * left);
        b.slope_x[k] = -bend * qx - b.cosine[k] * direction_y;
        b.slope_y[k] = -bend * qy + b.cosine[k] * direction_x;
        b.past_tail[k] = reach + b.cosine[k] * forward;
        b.before_head[k] = reach - b.cosine[k] * forward;
        terms.along[k] = 2.0 * (b.cosine[k] * e - b.sine[k] * left);
        terms.along_x[k] = -along_bend * qx + b.sine[k] * direction_y;
        terms.along_y[k] = -along_bend * qy - b.sine[k] * direction_x;
    }
}

// The distance from the circle of the arc is 2 |f| / (1 + |grad f|), whatever the curvature. A
// point behind an end of the arc is at least as far from the arc as from the line that is normal to
// it there.
inline void ArcLanes::find_bounds(Block& b) {
    const double far = kFar;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double slope = std::sqrt(b.slope_x[k] * b.slope_x[k] + b.slope_y[k] * b.slope_y[k]);
        const double distance = std::abs(b.twice[k]) / (1.0 + slope);
        const double end = min_value(b.past_tail[k], b.before_head[k]);
        b.facing[k] = end >= 0.0 ? distance : far;
        b.at_least[k] = max_value(distance, -end);
    }
}

inline void ArcLanes::convert_to_floats(Block& b, const Terms& terms) {
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double tangent_x = b.cosine[k] * terms.direction_x[k];
        const double tangent_y = b.cosine[k] * terms.direction_y[k];
        const double left_x = b.sine[k] * terms.direction_y[k];
        const double left_y = b.sine[k] * terms.direction_x[k];
        b.twice_float[k] = static_cast<float>(b.twice[k]);
        b.slope_x_float[k] = static_cast<float>(b.slope_x[k]);
        b.slope_y_float[k] = static_cast<float>(b.slope_y[k]);
        b.curvature_float[k] = static_cast<float>(2.0 * terms.over_chord[k] * b.sine[k]);
        b.tail_float[k] = static_cast<float>(b.past_tail[k]);
        b.tail_x_float[k] = static_cast<float>(tangent_x + left_x);
        b.tail_y_float[k] = static_cast<float>(tangent_y - left_y);
        b.head_float[k] = static_cast<float>(b.before_head[k]);
        b.head_x_float[k] = static_cast<float>(left_x - tangent_x);
        b.head_y_float[k] = static_cast<float>(-left_y - tangent_y);
        b.along_float[k] = static_cast<float>(terms.along[k]);
        b.along_x_float[k] = static_cast<float>(terms.along_x[k]);
        b.along_y_float[k] = static_cast<float>(terms.along_y[k]);
        b.along_curvature_float[k] = static_cast<float>(2.0 * terms.over_chord[k] * b.cosine[k]);
    }
}

void ArcLanes::evaluate_at(const Vec2& point) {
    Block* const blocks = blocks_.data();
    const std::size_t count = (size_ + kLanes - 1) / kLanes;
    const double x = point.x();
    const double y = point.y();
    at_simd_level([=] {
        for (std::size_t k = 0; k < count; ++k) {
            Terms terms{};
            find_directions(blocks[k], terms);
            find_functions(x, y, blocks[k], terms);
            find_bounds(blocks[k]);
            convert_to_floats(blocks[k], terms);
        }
    });
}

double ArcLanes::horizon(double reach) const {
    double nearest = kFar;
    for (std::size_t k = 0; k < size_; ++k) {
        nearest = std::min(nearest, at(&Block::facing, k));
    }
    return nearest + 2.0 * reach + PixelBatch::kMargin;
}

ArcFunctions ArcLanes::functions(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {{b.twice_float[k], b.slope_x_float[k], b.slope_y_float[k], b.curvature_float[k]},
            {b.tail_float[k], b.tail_x_float[k], b.tail_y_float[k]},
            {b.head_float[k], b.head_x_float[k], b.head_y_float[k]}};
}

FilmFunctions ArcLanes::film_functions(std::size_t k) const {
    const ArcFunctions arc = functions(k);
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {arc.across,
            {b.along_float[k], b.along_x_float[k], b.along_y_float[k], b.along_curvature_float[k]},
            static_cast<float>(b.chord[k])};
}

}  // namespace foam::texgen
