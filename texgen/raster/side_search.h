#pragma once

#include "texgen/raster/cell_mask.h"
#include "texgen/raster/distance_tile.h"
#include "texgen/raster/inset.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// A tile of pixels of a region, and what of it the region has.
struct RegionTile {
    int column = 0;  // of its lower left pixel, in the mask
    int row = 0;
    Vec2 middle{0.0, 0.0};
    std::array<std::uint8_t, DistanceTile::kSide> pixels{};  // a bit each, by rows
    std::uint8_t rows = 0;                                   // a bit for each that has any
};

/// The sides of a region, as a bubble or what is around a patch; finds which of them may be nearest
/// to a point of a tile. It halves the region again and again and drops what is too far from the
/// middle of a part, so that each tile is left with one or two sides, however many there are.
class SideSearch {
  public:
    struct Side {
        FieldArc arc;  // turns by no more than 120 degrees
        Vec2 tail;
        Vec2 head;
        bool corner = false;  // at the tail the region has more than 180 degrees
    };

    void clear() { sides_.clear(); }

    /// A closed boundary with the region on its left, in pixels. Arcs of no length are left out.
    void add_loop(std::span<const ArcLoops::Arc> loop);

    /// Calls visit(tile, sides) for every tile that the region has pixels of. `mask` shows them;
    /// its lower left corner is at (0, first_row) in the coordinates of the sides, first_row a
    /// multiple of DistanceTile::kSide.
    template <class Visit>
    void for_each_tile(const CellMask& mask, int first_row, const Visit& visit);

  private:
    struct Block {
        int x;  // in tiles
        int y;
        int tiles;  // of a side, a power of two
    };

    void add_side(const FilmArc& arc, const Vec2& tail);
    void narrow(std::size_t begin, std::size_t end, const Vec2& middle, double reach);
    template <class Visit>
    void visit_block(
        const CellMask& mask, int first_row, Block block, std::size_t begin, const Visit& visit);
    static RegionTile tile_at(const CellMask& mask, int first_row, Block block);

    std::vector<Side> sides_;
    std::vector<std::uint32_t> near_;  // those of a block after those of the one that holds it
    std::vector<double> distances_;
    std::vector<Side> kept_;
};

template <class Visit>
void SideSearch::for_each_tile(const CellMask& mask, int first_row, const Visit& visit) {
    near_.resize(sides_.size());
    for (std::size_t k = 0; k < near_.size(); ++k) {
        near_[k] = static_cast<std::uint32_t>(k);
    }
    int tiles = 1;
    while (tiles * DistanceTile::kSide < std::max(mask.columns(), mask.rows())) {
        tiles *= 2;
    }
    visit_block(mask, first_row, {0, 0, tiles}, 0, visit);
}

template <class Visit>
void SideSearch::visit_block(
    const CellMask& mask, int first_row, Block block, std::size_t begin, const Visit& visit) {
    constexpr int kSide = DistanceTile::kSide;
    const int columns = std::min(mask.columns() - block.x * kSide, block.tiles * kSide);
    const int rows = std::min(mask.rows() - block.y * kSide, block.tiles * kSide);
    if (columns <= 0 || rows <= 0) {
        return;
    }
    const std::size_t end = near_.size();
    if (block.tiles == 1) {
        const RegionTile tile = tile_at(mask, first_row, block);
        if (tile.rows != 0) {
            narrow(begin, end, tile.middle, DistanceTile::kReach);
            kept_.clear();
            for (std::size_t k = end; k < near_.size(); ++k) {
                kept_.push_back(sides_[near_[k]]);
            }
            visit(tile, std::span<const Side>(kept_));
        }
    } else {
        const Vec2 size(columns, rows);
        const Vec2 corner(block.x * kSide, first_row + block.y * kSide);
        narrow(begin, end, corner + 0.5 * size, 0.5 * size.norm());
        const int half = block.tiles / 2;
        for (const auto& [x, y] : {std::pair{0, 0}, {half, 0}, {0, half}, {half, half}}) {
            visit_block(mask, first_row, {block.x + x, block.y + y, half}, end, visit);
        }
    }
    near_.resize(end);
}

}  // namespace foam::texgen
