// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tile_copies.h"

#include "core/geometry/elementary.h"
#include "texgen/vector/tile_cut.h"

#include <cmath>

namespace foam::texgen {

namespace {

// A box with sides parallel to the axes.
struct Bounds {
    Vec2 low;
    Vec2 high;
};

// Returns a box that contains an arc. The box may be larger than necessary.
Bounds bounds_of(const DrawnArc& arc) {
    // No point of an arc is farther from the chord than the middle of the arc.
    const double sagitta =
        0.5 * (arc.head - arc.tail).norm() * ieee::tan(0.5 * std::abs(arc.half_angle));
    const Vec2 margin = Vec2::Constant(sagitta);
    return {arc.tail.cwiseMin(arc.head) - margin, arc.tail.cwiseMax(arc.head) + margin};
}

bool is_near_tile(const DrawnArc& arc, const Page& page, double reach) {
    const Bounds bounds = bounds_of(arc);
    return bounds.high.x() >= -reach && bounds.low.x() <= page.width + reach &&
           bounds.high.y() >= -reach && bounds.low.y() <= page.height + reach;
}

}  // namespace

std::vector<ArcCopy> copies_near_tile(const DrawnArc& arc, const Page& page, double reach) {
    const Bounds bounds = bounds_of(arc);
    const Vec2 tile(page.width, page.height);
    const Vec2 to_middle = 0.5 * (tile - bounds.low - bounds.high);
    const double extent = 0.5 * (bounds.high - bounds.low + tile).maxCoeff() + reach;
    std::vector<ArcCopy> copies;
    for (const LatticeOffset offset : page.domain.offsets_near(to_middle, extent)) {
        const DrawnArc copy = moved_by(arc, page.domain.translation(offset));
        if (is_near_tile(copy, page, reach)) {
            copies.push_back({copy, offset});
        }
    }
    return copies;
}

std::vector<DrawnArc> parts_beyond_tile(const DrawnArc& arc, const Page& page, double reach) {
    const Domain tile{page.width, page.height, 0.0};
    std::vector<DrawnArc> parts;
    for (const ArcCopy& copy : copies_near_tile(arc, page, reach)) {
        for (const CellPiece& piece : cut_at_cells(copy.arc, tile)) {
            const DrawnArc part = moved_by(piece.arc, tile.translation(piece.cell));
            if (!(piece.cell == LatticeOffset{}) && is_near_tile(part, page, reach)) {
                parts.push_back(part);
            }
        }
    }
    return parts;
}

}  // namespace foam::texgen
