#include "texgen/raster/near_sides.h"

#include "texgen/raster/vector_clones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

void NearSides::clear() {
    size_ = 0;
    corners_.clear();
}

void NearSides::add(const RegionSide& side) {
    if (size_ / kLanes == blocks_.size()) {
        blocks_.emplace_back();
    }
    set(size_, side.arc, 1.0 / side.arc.chord);
    if (side.corner) {
        corners_.push_back(size_);
    }
    ++size_;
}

void NearSides::set(std::size_t k, const FieldArc& arc, double over_chord) {
    Block& block = blocks_[k / kLanes];
    k %= kLanes;
    block.middle_x[k] = arc.middle.x();
    block.middle_y[k] = arc.middle.y();
    block.direction_x[k] = arc.direction.x();
    block.direction_y[k] = arc.direction.y();
    block.chord[k] = arc.chord;
    block.over_chord[k] = over_chord;
    block.cosine[k] = arc.cosine;
    block.sine[k] = arc.sine;
}

void NearSides::measure(double reach, bool gradient, PixelBatch& batch) {
    look_from(batch.middle());
    const double farthest = horizon(reach);
    batch.begin();
    for (std::size_t k = 0; k < size_; ++k) {
        if (!(at(&Block::at_least, k) <= farthest)) {
            continue;
        }
        if (gradient) {
            batch.add_arc_and_gradient(across(k), tail_line(k), head_line(k));
        } else {
            batch.add_arc(across(k), tail_line(k), head_line(k));
        }
    }
    if (!corners_.empty()) {
        add_corners(farthest, false, batch);
    }
    if (batch.is_unresolved()) {  // a pixel a little out of a sharp corner
        add_corners(kFar, true, batch);
    }
    batch.finish();
}

void NearSides::look_from(const Vec2& point) {
    for (std::size_t k = size_; k % kLanes != 0; ++k) {
        set(k, {}, 0.0);
    }
    for (std::size_t k = 0; k * kLanes < size_; ++k) {
        look_from(point, blocks_[k]);
    }
}

// As pencil_at and end_normals_at (field_arc.h). A point behind an end is at least as far from the
// arc as from the line there.
FOAMTEX_VECTOR_CLONES void NearSides::look_from(const Vec2& point, Block& block) {
    Block& b = block;
    const double x = point.x();
    const double y = point.y();
    const double far = kFar;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double qx = x - b.middle_x[k];
        const double qy = y - b.middle_y[k];
        const double along = qx * b.direction_x[k] + qy * b.direction_y[k];
        const double left = qy * b.direction_x[k] - qx * b.direction_y[k];
        const double bend = 2.0 * b.over_chord[k] * b.sine[k];
        const double e = 0.25 * b.chord[k] - (qx * qx + qy * qy) * b.over_chord[k];
        const double reach = 0.5 * b.chord[k] * b.cosine[k] - b.sine[k] * left;
        b.twice[k] = 2.0 * (b.sine[k] * e + b.cosine[k] * left);
        b.slope_x[k] = -bend * qx - b.cosine[k] * b.direction_y[k];
        b.slope_y[k] = -bend * qy + b.cosine[k] * b.direction_x[k];
        b.past_tail[k] = reach + b.cosine[k] * along;
        b.before_head[k] = reach - b.cosine[k] * along;
    }
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double length = std::sqrt(b.slope_x[k] * b.slope_x[k] + b.slope_y[k] * b.slope_y[k]);
        const double distance = std::abs(b.twice[k]) / (1.0 + length);
        const double end = b.past_tail[k] < b.before_head[k] ? b.past_tail[k] : b.before_head[k];
        b.facing[k] = end >= 0.0 ? distance : far;
        b.at_least[k] = distance > -end ? distance : -end;
    }
}

double NearSides::horizon(double reach) const {
    double nearest = kFar;
    for (std::size_t k = 0; k < size_; ++k) {
        nearest = std::min(nearest, at(&Block::facing, k));
    }
    return nearest + 2.0 * reach + PixelBatch::kMargin;
}

FloatQuadratic NearSides::across(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {static_cast<float>(b.twice[k]),
            static_cast<float>(b.slope_x[k]),
            static_cast<float>(b.slope_y[k]),
            static_cast<float>(2.0 * b.over_chord[k] * b.sine[k])};
}

FloatLine NearSides::tail_line(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {static_cast<float>(b.past_tail[k]),
            static_cast<float>(b.cosine[k] * b.direction_x[k] + b.sine[k] * b.direction_y[k]),
            static_cast<float>(b.cosine[k] * b.direction_y[k] - b.sine[k] * b.direction_x[k])};
}

FloatLine NearSides::head_line(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {static_cast<float>(b.before_head[k]),
            static_cast<float>(b.sine[k] * b.direction_y[k] - b.cosine[k] * b.direction_x[k]),
            static_cast<float>(-b.sine[k] * b.direction_x[k] - b.cosine[k] * b.direction_y[k])};
}

Vec2 NearSides::end(std::size_t k, double sign) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    const double half = 0.5 * sign * b.chord[k];
    return {b.middle_x[k] + half * b.direction_x[k], b.middle_y[k] + half * b.direction_y[k]};
}

// Those at the tails of sides, where the region has more than 180 degrees; or all ends.
void NearSides::add_corners(double farthest, bool all, PixelBatch& batch) const {
    for (const std::size_t k : corners_) {
        if (at(&Block::at_least, k) <= farthest) {
            batch.add_point(end(k, -1.0) - batch.middle());
        }
    }
    for (std::size_t k = 0; all && k < size_; ++k) {
        batch.add_point(end(k, -1.0) - batch.middle());
        batch.add_point(end(k, 1.0) - batch.middle());
    }
}

}  // namespace foam::texgen
