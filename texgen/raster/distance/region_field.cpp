#include "texgen/raster/distance/region_field.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kTileReach = 8.276472678623424;  // sqrt(7.5² + 3.5²), to the farthest pixel center
constexpr int kSmall = 40;                        // columns and rows of a region that is one batch
constexpr std::size_t kFewSides = 24;             // of which every batch looks at each
// A film adds less than 1e-8 to a smooth distance, and its functions may leave the range of floats,
// if its chord is shorter than this part of its distance.
constexpr double kLeastChord = 1e-4;
constexpr float kNowhere = 1e15F;  // where the film of a circle ends

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
    if (mask.columns() <= kSmall && rows <= kSmall && arcs.size() <= kFewSides) {
        measure_at_once(mask, rows);
        return;
    }
    const int first = mask.rows().begin / kTileRows;
    int tiles = 1;
    while (tiles * kTileColumns < mask.columns() || (first + tiles) * kTileRows < mask.rows().end) {
        tiles *= 2;
    }
    halve(mask, arcs, {0, first, tiles}, 0);
}

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

// Measures a block if it has few arcs near or is a single tile. Otherwise its arcs are narrowed to
// those that may be nearest to its pixels, and its quarters follow.
void RegionField::halve(const PixelMask& mask,
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
    if (block.tiles == 1 || arcs.size() <= kFewSides) {
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
    halve(mask, near, {block.x, block.y, half}, level + 1);
    halve(mask, near, {block.x + half, block.y, half}, level + 1);
    halve(mask, near, {block.x, block.y + half, half}, level + 1);
    halve(mask, near, {block.x + half, block.y + half, half}, level + 1);
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

// Makes the pixels of a tile the batch.
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

// `reach` is at least the distance from the middle of the batch to its farthest pixel.
void RegionField::measure_batch(const ArcLanes& arcs, double reach) {
    if (batch_.is_empty()) {
        return;
    }
    const Vec2 to_batch = offset_ - batch_.middle();
    view_.evaluate(arcs, -to_batch);
    const double horizon = view_.horizon(reach);
    grow(functions_, arcs.size());
    points_.clear();
    std::size_t count = 0;  // no branch: which arcs are near is unpredictable
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        functions_[count] = view_.functions(k);
        count += view_.is_within(k, horizon) ? 1U : 0U;
    }
    for (std::size_t k = 0; arcs.has_corners() && k < arcs.size(); ++k) {
        if (arcs.has_corner(k) && view_.is_within(k, horizon)) {
            points_.push_back(arcs.tail(k) + to_batch);
        }
    }
    const std::span<const ArcFunctions> near = std::span(functions_).first(count);
    const bool gradient = needs_.gradient || needs_.smooth;
    if (!batch_.measure(near, points_, gradient)) {  // slightly outside of a sharp corner
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
        if (chord.norm() > kLeastChord * far) {
            films_.push_back(view_.film_functions(k));
            if (is_circle) {
                films_.back().along = {kNowhere, 0.0F, 0.0F, 0.0F};
            }
        }
    }
    batch_.measure_smooth(films_);
}

}  // namespace foam::texgen
