#pragma once

#include "texgen/raster/cell_mask.h"
#include "texgen/raster/distance.h"
#include "texgen/raster/near_sides.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace foam::texgen {

/// What the pixels of a region, as a bubble or what is around a patch, are measured from. Keeps its
/// working memory from one region to the next.
///
/// Pixels are measured in batches: those of a small region at once, of others by tiles. Which sides
/// may be nearest is found by halving a region with many sides again and again; what is too far
/// from the middle of a part is dropped.
class RegionField {
  public:
    enum class Kind {
        Bubble,
        Circle,  // a bubble whose boundary is a whole circle, in arcs
        Around,  // without smooth distances of its own
    };

    static constexpr int kTileColumns = 16;  // pixels
    static constexpr int kTileRows = 8;

    void clear(Kind kind);

    /// The next side of a boundary, in pixels; boundaries have the region on their left.
    void add_side(const FieldArc& arc);
    void close_boundary();

    /// The pixels of a region, from its lower left corner.
    struct Pixels {
        const CellMask& mask;
        int first_row = 0;  // of the mask's, a multiple of kTileRows
        int rows = 0;       // of the whole region, which the mask may hold a part of
    };

    /// Calls visit(batch) for batches of all pixels of the mask, measured.
    template <class Visit>
    void measure(const Pixels& pixels, DistanceNeeds needs, const Visit& visit);

  private:
    // From the middle of a tile to the centre of its farthest pixel.
    static constexpr double kTileReach = 8.276472678623424;  // sqrt(7.5² + 3.5²)
    static constexpr int kSmall = 40;  // columns and rows of a region that is one batch
    static constexpr std::size_t kFewSides = 24;

    struct Block {
        int x;  // in tiles
        int y;
        int tiles;  // of a side, a power of two
    };

    bool is_small(const Pixels& pixels) const {
        return pixels.mask.columns() <= kSmall && pixels.rows <= kSmall &&
               sides_.size() <= kFewSides;
    }
    void start();
    template <class Visit>
    void halve(const Pixels& pixels, Block block, std::size_t begin, const Visit& visit);
    void narrow(std::size_t begin, std::size_t end, const Vec2& middle, double reach);
    void take_sides(std::size_t begin);
    void take_all(const Pixels& pixels);
    void take_tile(const Pixels& pixels, int x, int y);
    void measure_batch(double reach, DistanceNeeds needs);

    Kind kind_ = Kind::Bubble;
    std::vector<RegionSide> sides_;
    std::vector<FieldArc> films_;
    std::size_t boundary_ = 0;         // its first side
    std::vector<std::uint32_t> near_;  // those of a block after those of the one that holds it
    std::vector<double> distances_;
    NearSides few_;
    PixelBatch batch_;
};

template <class Visit>
void RegionField::measure(const Pixels& pixels, DistanceNeeds needs, const Visit& visit) {
    const CellMask& mask = pixels.mask;
    const auto visit_batch = [&](double reach) {
        if (!batch_.is_empty()) {
            measure_batch(reach, needs);
            visit(std::as_const(batch_));
        }
    };
    if (is_small(pixels)) {
        take_all(pixels);
        visit_batch(0.5 * Vec2(mask.columns(), pixels.rows).norm());
        return;
    }
    const auto visit_tiles = [&](Block block) {
        const int columns =
            std::min(block.tiles, (mask.columns() - 1) / kTileColumns + 1 - block.x);
        const int rows = std::min(block.tiles, (mask.rows() - 1) / kTileRows + 1 - block.y);
        for (int k = 0; k < rows * columns; ++k) {
            take_tile(pixels, block.x + k % columns, block.y + k / columns);
            visit_batch(kTileReach);
        }
    };
    start();
    int tiles = 1;
    while (tiles * kTileColumns < mask.columns() || tiles * kTileRows < mask.rows()) {
        tiles *= 2;
    }
    halve(pixels, {0, 0, tiles}, 0, visit_tiles);
}

// Visits the parts of a block that have few sides near, or are one tile, with these sides taken.
template <class Visit>
void RegionField::halve(const Pixels& pixels, Block block, std::size_t begin, const Visit& visit) {
    const CellMask& mask = pixels.mask;
    const int columns =
        std::min(mask.columns() - block.x * kTileColumns, block.tiles * kTileColumns);
    const int rows = std::min(mask.rows() - block.y * kTileRows, block.tiles * kTileRows);
    if (columns <= 0 || rows <= 0) {
        return;
    }
    const std::size_t end = near_.size();
    if (block.tiles == 1 || end - begin <= kFewSides) {
        take_sides(begin);
        visit(block);
        return;
    }
    const Vec2 size(columns, rows);
    const Vec2 corner(block.x * kTileColumns, pixels.first_row + block.y * kTileRows);
    narrow(begin, end, corner + 0.5 * size, 0.5 * size.norm());
    const int half = block.tiles / 2;
    for (const auto& [x, y] : {std::pair{0, 0}, {half, 0}, {0, half}, {half, half}}) {
        halve(pixels, {block.x + x, block.y + y, half}, end, visit);
    }
    near_.resize(end);
}

}  // namespace foam::texgen
