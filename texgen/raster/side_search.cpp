#include "texgen/raster/side_search.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr double kShortestSide = 1e-9;  // pixels; a shorter side has no direction to speak of
constexpr double kLargestHalfAngle = std::numbers::pi / 3.0;
// What the floats of a tile may be wrong by, pixels.
constexpr double kMargin = 0.01;

Vec2 tangent(const FieldArc& arc, double end) {
    return arc.cosine * arc.direction + end * arc.sine * turned_left(arc.direction);
}

bool turns_right(const FieldArc& before, const FieldArc& after) {
    return cross(tangent(before, 1.0), tangent(after, -1.0)) < 0.0;
}

// The middle of an arc lies its sagitta to the right of that of the chord.
FilmArc first_half(const FilmArc& arc) {
    const double half = 0.5 * arc.half_angle;
    return {0.5 * (arc.chord - std::tan(half) * turned_left(arc.chord)), half};
}

}  // namespace

void SideSearch::add_loop(std::span<const ArcLoops::Arc> loop) {
    const std::size_t first = sides_.size();
    for (const ArcLoops::Arc& side : loop) {
        if (side.arc.chord.norm() > kShortestSide) {
            add_side(side.arc, side.tail);
        }
    }
    for (std::size_t k = first; k < sides_.size(); ++k) {
        const Side& before = k == first ? sides_.back() : sides_[k - 1];
        sides_[k].corner = turns_right(before.arc, sides_[k].arc);
    }
}

void SideSearch::add_side(const FilmArc& arc, const Vec2& tail) {
    if (std::abs(arc.half_angle) <= kLargestHalfAngle) {
        sides_.push_back({field_arc(arc, tail), tail, tail + arc.chord, false});
        return;
    }
    const FilmArc half = first_half(arc);
    add_side(half, tail);
    add_side({arc.chord - half.chord, half.half_angle}, tail + half.chord);
}

// Appends those of a range that may be nearest to some point within reach of the middle.
void SideSearch::narrow(std::size_t begin, std::size_t end, const Vec2& middle, double reach) {
    distances_.clear();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = begin; k < end; ++k) {
        distances_.push_back(distance(sides_[near_[k]].arc, middle));
        least = std::min(least, distances_.back());
    }
    for (std::size_t k = begin; k < end; ++k) {
        if (distances_[k - begin] <= least + 2.0 * reach + kMargin) {
            near_.push_back(near_[k]);
        }
    }
}

RegionTile SideSearch::tile_at(const CellMask& mask, int first_row, Block block) {
    constexpr int kSide = DistanceTile::kSide;
    RegionTile tile{block.x * kSide, block.y * kSide, {}, {}, 0};
    tile.middle = Vec2(tile.column, tile.row + first_row) + Vec2::Constant(0.5 * kSide);
    for (int k = 0; k < std::min(kSide, mask.rows() - tile.row); ++k) {
        const std::uint8_t pixels = mask.eight(block.x, tile.row + k);
        tile.pixels[static_cast<std::size_t>(k)] = pixels;
        tile.rows = static_cast<std::uint8_t>(tile.rows | (pixels != 0 ? 1 << k : 0));
    }
    return tile;
}

}  // namespace foam::texgen
