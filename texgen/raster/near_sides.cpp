#include "texgen/raster/near_sides.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/simd/kernel.h"
#include "texgen/raster/simd/vector_clones.h"

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

bool NearSides::take(const BubbleSides& sides, const Vec2& first) {
    clear();
    if (sides.count > kLanes) {
        return false;
    }
    if (blocks_.empty()) {
        blocks_.emplace_back();
    }
    if (!place(sides.lanes.front(), sides.count, first, blocks_.front())) {
        return false;
    }
    size_ = sides.count;
    Lanes turns;
    if (find_corners(blocks_.front(), size_, turns)) {
        for (std::size_t k = 0; k < size_; ++k) {
            if (turns[k] < 0.0) {
                corners_.push_back(k);
            }
        }
    }
    return true;
}

// As field_arc.
FOAMTEX_VECTOR_CLONES bool NearSides::place(const SideLanes& sides,
                                            std::size_t count,
                                            const Vec2& first,
                                            Block& block) {
    Block& b = block;
    Lanes tail_x;
    Lanes tail_y;
    double x = first.x();
    double y = first.y();
    for (std::size_t k = 0; k < kLanes; ++k) {
        tail_x[k] = x;
        tail_y[k] = y;
        x += sides.chord_x[k];
        y += sides.chord_y[k];
    }
    double unfit = 0.0;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double chord_x = sides.chord_x[k];
        const double chord_y = sides.chord_y[k];
        const double chord = std::sqrt(chord_x * chord_x + chord_y * chord_y);
        const bool has_length = chord > kShortestSide;
        const bool is_side = k < count;
        const double length = has_length ? chord : 1.0;
        b.middle_x[k] = tail_x[k] + 0.5 * chord_x;
        b.middle_y[k] = tail_y[k] + 0.5 * chord_y;
        b.direction_x[k] = chord_x / length;
        b.direction_y[k] = chord_y / length;
        b.chord[k] = chord;
        b.over_chord[k] = has_length ? 1.0 / length : 0.0;
        b.cosine[k] = sides.cosine[k];
        b.sine[k] = sides.sine[k];
        const bool fits = has_length && sides.cosine[k] >= kLeastSideCosine;
        unfit += is_side && !fits ? 1.0 : 0.0;
    }
    return unfit == 0.0;
}

// By what the region turns to the left where each side begins, a sine; whether any turns right.
FOAMTEX_VECTOR_CLONES bool NearSides::find_corners(const Block& block,
                                                   std::size_t count,
                                                   Lanes& turns) {
    const Block& b = block;
    std::array<double, kLanes + 1> head_x{};  // tangents; before the first side comes the last one
    std::array<double, kLanes + 1> head_y{};
    for (std::size_t k = 0; k < kLanes; ++k) {
        head_x[k + 1] = b.cosine[k] * b.direction_x[k] + b.sine[k] * -b.direction_y[k];
        head_y[k + 1] = b.cosine[k] * b.direction_y[k] + b.sine[k] * b.direction_x[k];
    }
    head_x[0] = head_x[count];
    head_y[0] = head_y[count];
    double right = 0.0;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double tail_x = b.cosine[k] * b.direction_x[k] - b.sine[k] * -b.direction_y[k];
        const double tail_y = b.cosine[k] * b.direction_y[k] - b.sine[k] * b.direction_x[k];
        turns[k] = head_x[k] * tail_y - head_y[k] * tail_x;
        right += k < count && turns[k] < 0.0 ? 1.0 : 0.0;
    }
    return right != 0.0;
}

FieldArc NearSides::arc(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {{b.middle_x[k], b.middle_y[k]},
            {b.direction_x[k], b.direction_y[k]},
            b.chord[k],
            b.cosine[k],
            b.sine[k]};
}

void NearSides::measure(double reach, bool gradient, PixelBatch& batch) {
    look_from(batch.middle());
    const double farthest = horizon(reach);
    grow(near_, size_);
    std::size_t count = 0;  // no branch: nobody foresees which are near
    for (std::size_t k = 0; k < size_; ++k) {
        near_[count] = in_floats(k);
        count += at(&Block::at_least, k) <= farthest ? 1U : 0U;
    }
    const std::span<const FloatArc> near = std::span(near_).first(count);
    if (gradient) {
        batch.add_arcs_and_gradients(near);
    } else {
        batch.add_arcs(near);
    }
    if (!corners_.empty()) {
        add_corners(farthest, false, batch);
    }
    if (!batch.finish()) {  // a pixel a little out of a sharp corner
        add_corners(kFar, true, batch);
        batch.finish();
    }
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
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double bend = 2.0 * b.over_chord[k] * b.sine[k];
        const double along_x = b.cosine[k] * b.direction_x[k];
        const double along_y = b.cosine[k] * b.direction_y[k];
        const double left_x = b.sine[k] * b.direction_y[k];
        const double left_y = b.sine[k] * b.direction_x[k];
        b.twice_float[k] = static_cast<float>(b.twice[k]);
        b.slope_x_float[k] = static_cast<float>(b.slope_x[k]);
        b.slope_y_float[k] = static_cast<float>(b.slope_y[k]);
        b.curvature_float[k] = static_cast<float>(bend);
        b.tail_float[k] = static_cast<float>(b.past_tail[k]);
        b.tail_x_float[k] = static_cast<float>(along_x + left_x);
        b.tail_y_float[k] = static_cast<float>(along_y - left_y);
        b.head_float[k] = static_cast<float>(b.before_head[k]);
        b.head_x_float[k] = static_cast<float>(left_x - along_x);
        b.head_y_float[k] = static_cast<float>(-left_y - along_y);
    }
}

double NearSides::horizon(double reach) const {
    double nearest = kFar;
    for (std::size_t k = 0; k < size_; ++k) {
        nearest = std::min(nearest, at(&Block::facing, k));
    }
    return nearest + 2.0 * reach + PixelBatch::kMargin;
}

FloatArc NearSides::in_floats(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {{b.twice_float[k], b.slope_x_float[k], b.slope_y_float[k], b.curvature_float[k]},
            {b.tail_float[k], b.tail_x_float[k], b.tail_y_float[k]},
            {b.head_float[k], b.head_x_float[k], b.head_y_float[k]}};
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
