// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tile_cut.h"

#include "core/geometry/elementary.h"
#include "texgen/vector/border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

// Cuts closer to an end of an arc than this fraction of `reach` (ParameterArc) are left out. Points
// closer to a border of the tile than this fraction of the tile's width or height are moved onto
// the border.
constexpr double kEndTolerance = 1e-12;

constexpr int kX = 0;
constexpr int kY = 1;

// An arc whose points are given by the parameter s of OffsetArc (raster/outline/offset_arc.h). The
// point with the parameter s is middle + s / (1 + z²) (direction + z normal), with z = k s / 2.
// Here k is the curvature, and `direction` and `normal` are the unit tangent and the unit normal at
// the middle of the arc.
class ParameterArc {
  public:
    explicit ParameterArc(const DrawnArc& arc) : arc_(arc) {
        const Vec2 chord = arc.head - arc.tail;
        const double length = chord.norm();
        const auto [sine, cosine] = ieee::sincos(arc.half_angle);
        direction_ = length > 0.0 ? Vec2(chord / length) : Vec2(1.0, 0.0);
        curvature_ = length > 0.0 ? 2.0 * sine / length : 0.0;
        reach_ = length / (1.0 + cosine);
        sagitta_ = 0.5 * reach_ * sine;
        middle_ = arc.tail + 0.5 * chord - sagitta_ * turned_left(direction_);
    }

    // Returns the parameter of the head. The parameter of the tail is -reach.
    double reach() const { return reach_; }
    double sagitta() const { return std::abs(sagitta_); }

    Vec2 at(double s) const {
        const double z = 0.5 * curvature_ * s;
        return middle_ + s / (1.0 + z * z) * (direction_ + z * turned_left(direction_));
    }

    // Returns the part of the arc between two parameters. `tail` and `head` are the ends of the
    // part.
    DrawnArc part(double from, double to, const Vec2& tail, const Vec2& head) const {
        if (from <= -reach_ && to >= reach_) {
            return {tail, head, arc_.half_angle};
        }
        const double turn = ieee::atan(0.5 * curvature_ * to) - ieee::atan(0.5 * curvature_ * from);
        return {tail, head, turn};
    }

    // Adds the parameters of the points of the arc whose coordinate on `axis` is `value`. They are
    // the roots of s² (k n / 2 - e k² / 4) + t s - e = 0. Here t and n are the components of the
    // tangent and the normal on the axis, and e is `value` minus the coordinate of the middle.
    void add_crossings(int axis, double value, std::vector<double>& found) const {
        const double e = value - middle_[axis];
        const double t = direction_[axis];
        const double n = turned_left(direction_)[axis];
        const double a = 0.5 * curvature_ * (n - 0.5 * e * curvature_);
        const double square = t * t + 4.0 * a * e;
        if (square < 0.0) {
            return;
        }
        const double q = t + std::copysign(std::sqrt(square), t);
        for (const double s : {2.0 * e / q, -0.5 * q / a}) {
            if (std::abs(s) < (1.0 - kEndTolerance) * reach_) {
                found.push_back(s);
            }
        }
    }

  private:
    DrawnArc arc_;
    Vec2 direction_;
    Vec2 middle_;
    double curvature_ = 0.0;
    double reach_ = 0.0;
    double sagitta_ = 0.0;
};

// A point at which an arc is cut, or one of its ends.
struct Cut {
    double parameter = 0.0;
    Vec2 point{0.0, 0.0};
};

// Cuts the part of an arc from `from` to `to` at the points whose coordinate on `axis` is `shift`
// plus a whole multiple of `period`. Returns all cuts in order, including `from` and `to`.
std::vector<Cut> cuts_between(const ParameterArc& arc,
                              const Cut& from,
                              const Cut& to,
                              int axis,
                              double period,
                              double shift) {
    const double low = std::min(from.point[axis], to.point[axis]) - arc.sagitta();
    const double high = std::max(from.point[axis], to.point[axis]) + arc.sagitta();
    std::vector<Cut> cuts{from};
    for (double k = std::floor((low - shift) / period); k * period + shift <= high; k += 1.0) {
        std::vector<double> found;
        arc.add_crossings(axis, k * period + shift, found);
        for (const double s : found) {
            if (s > from.parameter && s < to.parameter) {
                cuts.push_back({s, arc.at(s)});
                cuts.back().point[axis] = k * period + shift;
            }
        }
    }
    cuts.push_back(to);
    std::ranges::sort(cuts, {}, &Cut::parameter);
    return cuts;
}

// Moves a point from a cell of the torus, which is a translated copy of the tile (Domain), into the
// tile. A coordinate that differs from a border only by rounding errors becomes exactly the
// coordinate of the border.
Vec2 moved_into_tile(const Vec2& point, LatticeOffset cell, const Domain& torus) {
    Vec2 inside = point - torus.translation(cell);
    const Vec2 size(torus.width, torus.height);
    for (const int axis : {kX, kY}) {
        const double tolerance = kEndTolerance * size[axis];
        if (std::abs(inside[axis]) < tolerance) {
            inside[axis] = 0.0;
        } else if (std::abs(inside[axis] - size[axis]) < tolerance) {
            inside[axis] = size[axis];
        }
    }
    return inside;
}

CellPiece piece_between(const ParameterArc& arc, const Cut& a, const Cut& b, const Domain& torus) {
    const LatticeOffset cell = torus.cell_of(arc.at(0.5 * (a.parameter + b.parameter)));
    return {arc.part(a.parameter,
                     b.parameter,
                     moved_into_tile(a.point, cell, torus),
                     moved_into_tile(b.point, cell, torus)),
            cell};
}

}  // namespace

std::vector<CellPiece> cut_at_cells(const DrawnArc& arc, const Domain& torus) {
    const ParameterArc curve(arc);
    const Cut tail{-curve.reach(), arc.tail};
    const Cut head{curve.reach(), arc.head};
    const std::vector<Cut> rows = cuts_between(curve, tail, head, kY, torus.height, 0.0);
    std::vector<CellPiece> pieces;
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
        const double middle = 0.5 * (rows[k].parameter + rows[k + 1].parameter);
        const double shift = torus.cell_of(curve.at(middle)).j * torus.shear;
        const std::vector<Cut> cuts =
            cuts_between(curve, rows[k], rows[k + 1], kX, torus.width, shift);
        for (std::size_t m = 0; m + 1 < cuts.size(); ++m) {
            pieces.push_back(piece_between(curve, cuts[m], cuts[m + 1], torus));
        }
    }
    return pieces;
}

namespace {

using CellKey = std::pair<std::int32_t, std::int32_t>;

CellKey key_of(LatticeOffset cell) {
    return {cell.j, cell.i};
}

std::vector<CellPiece> pieces_of(const Chain& chain, const Domain& torus) {
    std::vector<CellPiece> pieces;
    for (const DrawnArc& arc : arcs_of(chain)) {
        const std::vector<CellPiece> cut = cut_at_cells(arc, torus);
        pieces.insert(pieces.end(), cut.begin(), cut.end());
    }
    return pieces;
}

// Joins successive pieces of a closed chain that are in the same cell, and calls
// add(cell, chain) for each result.
template <class Add>
void add_chains_in_cells(std::span<const CellPiece> pieces, const Add& add) {
    const std::size_t count = pieces.size();
    const auto starts_chain = [&](std::size_t k) {
        return !(pieces[k].cell == pieces[(k + count - 1) % count].cell);
    };
    std::size_t first = 0;
    while (first < count && !starts_chain(first)) {
        ++first;
    }
    std::vector<DrawnArc> arcs;
    if (first == count) {  // the whole chain is in one cell
        std::ranges::transform(pieces, std::back_inserter(arcs), &CellPiece::arc);
        add(key_of(pieces.front().cell), chain_of(arcs, true));
        return;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const CellPiece& piece = pieces[(first + k) % count];
        arcs.push_back(piece.arc);
        if (k + 1 == count || starts_chain((first + k + 1) % count)) {
            add(key_of(piece.cell), chain_of(arcs, false));
            arcs.clear();
        }
    }
}

// Returns the winding number of a closed chain around the tile, which is the cell (0, 0). The
// winding number is the number of downward minus the number of upward crossings of the line y = 0
// to the left of the tile. The result has no meaning if the chain crosses the border of the tile.
int winding_around_tile(std::span<const CellPiece> pieces) {
    int winding = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const LatticeOffset from = pieces[k].cell;
        const LatticeOffset to = pieces[(k + 1) % pieces.size()].cell;
        if (std::min(from.i, to.i) < 0) {
            winding += (from.j >= 0 ? 1 : 0) - (to.j >= 0 ? 1 : 0);
        }
    }
    return winding;
}

}  // namespace

std::vector<Chain> closed_in_cells(const Chain& chain, const Domain& torus) {
    std::map<CellKey, std::vector<Chain>> by_cell;
    const std::vector<CellPiece> pieces = pieces_of(chain, torus);
    add_chains_in_cells(
        pieces, [&](const CellKey& cell, Chain part) { by_cell[cell].push_back(std::move(part)); });
    std::vector<Chain> closed;
    for (auto& [cell, parts] : by_cell) {
        std::ranges::move(closed_along_border(std::move(parts), torus.width, torus.height),
                          std::back_inserter(closed));
    }
    return closed;
}

Chain tile_outline(double width, double height) {
    Chain tile{{0.0, 0.0}, {}, true};
    for (const Vec2& corner :
         {Vec2(width, 0.0), Vec2(width, height), Vec2(0.0, height), Vec2(0.0, 0.0)}) {
        tile.steps.push_back({corner, 0.0});
    }
    return tile;
}

std::vector<Chain> clipped_to_tile(const std::vector<Chain>& chains, double width, double height) {
    const Domain tile{width, height, 0.0};
    std::vector<Chain> inside;
    int winding = 0;
    for (const Chain& chain : chains) {
        const std::vector<CellPiece> pieces = pieces_of(chain, tile);
        winding += winding_around_tile(pieces);
        add_chains_in_cells(pieces, [&](const CellKey& cell, Chain part) {
            if (cell == CellKey{0, 0}) {
                inside.push_back(std::move(part));
            }
        });
    }
    // The region is on the left of the chains. If no chain crosses the border of the tile, all of
    // the border is in the region or none of it.
    if (winding > 0 && std::ranges::all_of(inside, &Chain::is_closed)) {
        inside.push_back(tile_outline(width, height));
    }
    return closed_along_border(std::move(inside), width, height);
}

}  // namespace foam::texgen
