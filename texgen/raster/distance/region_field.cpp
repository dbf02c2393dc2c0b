// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/region_field.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

// Arcs are culled by distance. Let d be the distance from the middle of a batch to the nearest arc
// that the middle faces, and r the reach: the distance from the middle to the farthest pixel of the
// batch. An arc that is farther from the middle than d + 2 r is not the nearest arc of any pixel
// (ArcView::horizon). The same test at the middle of a block of tiles selects the arcs that are
// tested for all parts of the block.

// sqrt(7.5² + 3.5²), the distance from the middle of a tile to its farthest pixel center.
constexpr double kTileReach = 8.276472678623424;
// The largest number of columns and of rows of a region that is measured as one batch.
constexpr int kMaxBatchSide = 40;
// A region or a block of tiles with at most this number of arcs is not subdivided to cull arcs.
constexpr std::size_t kMaxUnculledArcs = 24;
// A film whose chord is at most this fraction of its distance from the farthest pixel of a batch is
// ignored in smooth distances. The film would add only about 1e-8 / distance² to the sum of 1/phi²,
// and its functions could leave the range of floats.
constexpr double kMinChord = 1e-4;
// For a circle, whose film has no ends, FilmFunctions::along is a constant. This is twice the
// constant: so large that every pixel counts as beside the film, not beyond its ends.
constexpr float kNoEnd = 1e15F;

}  // namespace

void RegionField::measure(const Region& region,
                          const RegionPixels& pixels,
                          DistanceNeeds needs,
                          const Visit& visit) {
    needs_ = needs;
    visit_ = &visit;
    region_ = &region;
    offset_ = pixels.offset();
    const ArcLanes& arcs = region.boundary.arcs();
    const PixelMask& mask = pixels.mask();
    const int rows = pixels.box().rows();
    if (mask.columns() <= kMaxBatchSide && rows <= kMaxBatchSide &&
        arcs.size() <= kMaxUnculledArcs) {
        measure_at_once(mask, rows);
        return;
    }
    const int first = mask.rows().begin / kTileRows;
    int tiles = 1;
    while (tiles * kTileColumns < mask.columns() || (first + tiles) * kTileRows < mask.rows().end) {
        tiles *= 2;
    }
    subdivide(mask, arcs, {0, first, tiles}, 0);
}

// Measures a small region as one batch. `rows` is the number of rows of its box.
void RegionField::measure_at_once(const PixelMask& mask, int rows) {
    batch_.clear(Vec2(mask.columns() / 2, rows / 2));
    at_simd_level([&mask, &batch = batch_] {
        for (int row = mask.rows().begin; row < mask.rows().end; ++row) {
            for_each_span_of_bits(mask.word(0, row),
                                  [&](int begin, int count) { batch.add_span(begin, row, count); });
        }
    });
    measure_batch(region_->boundary.arcs(), 0.5 * Vec2(mask.columns(), rows).norm());
}

// Measures a block of tiles. `arcs` are the arcs that may be the nearest arc of a pixel in the
// block, and `level` is the depth of the recursion. If the block is a single tile or has few arcs,
// its tiles are measured. Otherwise arcs that cannot be the nearest arc of any pixel of the block
// are dropped, and the quarters of the block are processed recursively.
void RegionField::subdivide(const PixelMask& mask,
                            const ArcLanes& arcs,
                            Block block,
                            std::size_t level) {
    const int left = block.x * kTileColumns;
    const int bottom = block.y * kTileRows;
    const int columns = std::min(mask.columns() - left, block.tiles * kTileColumns);
    const int rows = std::min(mask.rows().end - bottom, block.tiles * kTileRows);
    if (columns <= 0 || rows <= 0) {
        return;
    }
    if (block.tiles == 1 || arcs.size() <= kMaxUnculledArcs) {
        measure_tiles(mask, arcs, block);
        return;
    }
    if (level == near_.size()) {
        near_.emplace_back();
    }
    const Vec2 size(columns, rows);
    view_.evaluate(arcs, Vec2(left, bottom) + 0.5 * size - offset_);
    const double horizon = view_.horizon(0.5 * size.norm());
    ArcLanes& near = near_[level];
    near.clear();
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        if (view_.is_within(k, horizon)) {
            near.add(arcs, k);
        }
    }
    const int half = block.tiles / 2;
    subdivide(mask, near, {block.x, block.y, half}, level + 1);
    subdivide(mask, near, {block.x + half, block.y, half}, level + 1);
    subdivide(mask, near, {block.x, block.y + half, half}, level + 1);
    subdivide(mask, near, {block.x + half, block.y + half, half}, level + 1);
}

void RegionField::measure_tiles(const PixelMask& mask, const ArcLanes& arcs, Block block) {
    const int right = std::min(block.x + block.tiles, (mask.columns() - 1) / kTileColumns + 1);
    const int top = std::min(block.y + block.tiles, (mask.rows().end - 1) / kTileRows + 1);
    for (int y = block.y; y < top; ++y) {
        for (int x = block.x; x < right; ++x) {
            take_tile(mask, x, y);
            measure_batch(arcs, kTileReach);
        }
    }
}

// Fills the batch with the pixels of the region in a tile. `x` and `y` are the column and the row
// of the tile, counted in tiles.
void RegionField::take_tile(const PixelMask& mask, int x, int y) {
    constexpr int kTilesPerWord = PixelMask::kWordColumns / kTileColumns;
    const int column = x * kTileColumns;
    const int row = y * kTileRows;
    batch_.clear(Vec2(column + 0.5 * kTileColumns, row + 0.5 * kTileRows));
    const int end = std::min(row + kTileRows, mask.rows().end);
    for (int k = std::max(row, mask.rows().begin); k < end; ++k) {
        const std::uint64_t word = mask.word(x / kTilesPerWord, k);
        const auto bits = static_cast<std::uint16_t>(word >> (x % kTilesPerWord * kTileColumns));
        for_each_span_of_bits(
            bits, [&](int begin, int count) { batch_.add_span(column + begin, k, count); });
    }
}

// Measures the batch and passes it to the visitor. `arcs` are the arcs that may be the nearest arc
// of a pixel. Precondition: `reach` is at least the distance from the middle of the batch to its
// farthest pixel.
void RegionField::measure_batch(const ArcLanes& arcs, double reach) {
    if (batch_.is_empty()) {
        return;
    }
    const Vec2 to_batch = offset_ - batch_.middle();
    view_.evaluate(arcs, -to_batch);
    const double horizon = view_.horizon(reach);
    grow(functions_, arcs.size());
    points_.clear();
    // The number of near arcs. The loop counts them without a branch, which would be unpredictable.
    std::size_t count = 0;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        functions_[count] = view_.arc_functions(k);
        count += view_.is_within(k, horizon) ? 1U : 0U;
    }
    for (std::size_t k = 0; arcs.has_corners() && k < arcs.size(); ++k) {
        if (arcs.has_corner(k) && view_.is_within(k, horizon)) {
            points_.push_back(arcs.tail(k) + to_batch);
        }
    }
    const std::span<const ArcFunctions> near = std::span(functions_).first(count);
    const bool gradient = needs_.gradient || needs_.smooth;
    // A pixel slightly outside of a sharp corner may face no arc. Then distances to the ends of all
    // arcs are included.
    if (!batch_.measure(near, points_, gradient)) {
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            points_.push_back(arcs.tail(k) + to_batch);
            points_.push_back(arcs.head(k) + to_batch);
        }
        batch_.measure(near, points_, gradient);
    }
    if (needs_.smooth) {
        measure_smooth(reach);
    }
    (*visit_)(batch_);
}

// Computes the smooth distances of the batch. For the surroundings, no films are passed to the
// batch, so that their smooth distances equal their distances. For a circle, only one of its two
// arcs is passed, since its function `across` is 0 on the whole circle.
void RegionField::measure_smooth(double reach) {
    static const ArcLanes none;
    const bool is_circle = region_->kind == RegionKind::Circle;
    const ArcLanes& films =
        region_->kind == RegionKind::Surroundings ? none : region_->boundary.films();
    const Vec2 point = batch_.middle() - offset_;
    view_.evaluate(films, point);
    films_.clear();
    for (std::size_t k = 0; k < films.size() && !(is_circle && k > 0); ++k) {
        const Vec2 chord = films.chord(k);
        const double far = (point - films.tail(k) - 0.5 * chord).norm() + reach;
        if (chord.norm() > kMinChord * far) {
            films_.push_back(view_.film_functions(k));
            if (is_circle) {
                films_.back().along = {kNoEnd, 0.0F, 0.0F, 0.0F};
            }
        }
    }
    batch_.measure_smooth(films_);
}

}  // namespace foam::texgen
