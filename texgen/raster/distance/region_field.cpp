#include "texgen/raster/distance/region_field.h"

#include "texgen/raster/coords/raster_grid.h"

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

bool has_direction(const DistanceArc& side) {
    return side.shape.chord.norm() > kShortestSide;
}

}  // namespace

void RegionField::measure(const RegionPixels& pixels, DistanceNeeds needs, const Visit& visit) {
    needs_ = needs;
    visit_ = &visit;
    take(pixels, needs.smooth);
    const PixelMask& mask = pixels.mask();
    const int rows = pixels.box().rows();
    if (mask.columns() <= kSmall && rows <= kSmall && arcs_.front().size() <= kFewSides) {
        measure_at_once(mask, rows);
        return;
    }
    const int first = mask.rows().begin / kTileRows;
    int tiles = 1;
    while (tiles * kTileColumns < mask.columns() || (first + tiles) * kTileRows < mask.rows().end) {
        tiles *= 2;
    }
    halve(mask, {0, first, tiles}, 0);
}

// A side without direction is left out.
void RegionField::take(const RegionPixels& pixels, bool smooth) {
    if (arcs_.empty()) {
        arcs_.emplace_back();
    }
    arcs_.front().clear();
    films_.clear();
    is_circle_ = pixels.region().kind == RegionKind::Circle;
    const bool has_films = smooth && pixels.region().kind != RegionKind::Surroundings;
    const Boundary& boundary = pixels.boundary();
    for (std::size_t loop = 0; loop < boundary.loop_ends.size(); ++loop) {
        const std::span<const DistanceArc> sides = boundary.loop(loop);
        const auto last = std::find_if(sides.rbegin(), sides.rend(), has_direction);
        const DistanceArc* before = last == sides.rend() ? nullptr : &*last;
        for (const DistanceArc& side : sides) {
            if (!has_direction(side)) {
                continue;
            }
            add_side(side.shape, side.tail, turns_right(before->shape, side.shape));
            before = &side;
            if (has_films && !(is_circle_ && films_.size() > 0)) {
                films_.add(side.shape, side.tail, false);
            }
        }
    }
}

void RegionField::add_side(const PixelArc& shape, const Vec2& tail, bool corner) {
    if (shape.cosine >= ArcLanes::kLeastCosine) {
        arcs_.front().add(shape, tail, corner);
        return;
    }
    const auto [first, second] = halves(shape);
    add_side(first, tail, corner);
    add_side(second, tail + first.chord, false);
}

void RegionField::measure_at_once(const PixelMask& mask, int rows) {
    batch_.clear(Vec2(mask.columns() / 2, rows / 2));
    for (int row = mask.rows().begin; row < mask.rows().end; ++row) {
        for_each_span_of_bits(mask.word(0, row),
                              [&](int begin, int count) { batch_.add_span(begin, row, count); });
    }
    measure_batch(arcs_.front(), 0.5 * Vec2(mask.columns(), rows).norm());
}

// Measures a block if it has few arcs near or is a single tile. Otherwise its arcs are narrowed to
// those that may be nearest to its pixels, and its quarters follow.
void RegionField::halve(const PixelMask& mask, Block block, std::size_t level) {
    const int left = block.x * kTileColumns;
    const int bottom = block.y * kTileRows;
    const int columns = std::min(mask.columns() - left, block.tiles * kTileColumns);
    const int rows = std::min(mask.rows().end - bottom, block.tiles * kTileRows);
    if (columns <= 0 || rows <= 0) {
        return;
    }
    if (block.tiles == 1 || arcs_[level].size() <= kFewSides) {
        measure_tiles(mask, block, arcs_[level]);
        return;
    }
    if (level + 1 == arcs_.size()) {
        arcs_.emplace_back();
    }
    ArcLanes& all = arcs_[level];
    ArcLanes& near = arcs_[level + 1];
    const Vec2 size(columns, rows);
    all.evaluate_at(Vec2(left, bottom) + 0.5 * size);
    const double horizon = all.horizon(0.5 * size.norm());
    near.clear();
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all.is_within(k, horizon)) {
            near.add(all, k);
        }
    }
    const int half = block.tiles / 2;
    halve(mask, {block.x, block.y, half}, level + 1);
    halve(mask, {block.x + half, block.y, half}, level + 1);
    halve(mask, {block.x, block.y + half, half}, level + 1);
    halve(mask, {block.x + half, block.y + half, half}, level + 1);
}

void RegionField::measure_tiles(const PixelMask& mask, Block block, ArcLanes& arcs) {
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
void RegionField::measure_batch(ArcLanes& arcs, double reach) {
    if (batch_.is_empty()) {
        return;
    }
    arcs.evaluate_at(batch_.middle());
    const double horizon = arcs.horizon(reach);
    near_.resize(arcs.size());
    points_.clear();
    std::size_t count = 0;  // no branch: which arcs are near is unpredictable
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        near_[count] = arcs.functions(k);
        count += arcs.is_within(k, horizon) ? 1U : 0U;
    }
    for (std::size_t k = 0; arcs.has_corners() && k < arcs.size(); ++k) {
        if (arcs.has_corner(k) && arcs.is_within(k, horizon)) {
            points_.push_back(arcs.tail(k) - batch_.middle());
        }
    }
    const std::span<const ArcFunctions> near = std::span(near_).first(count);
    const bool gradient = needs_.gradient || needs_.smooth;
    if (!batch_.measure(near, points_, gradient)) {  // a pixel slightly outside of a sharp corner
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            points_.push_back(arcs.tail(k) - batch_.middle());
            points_.push_back(arcs.head(k) - batch_.middle());
        }
        batch_.measure(near, points_, gradient);
    }
    if (needs_.smooth) {
        measure_smooth(reach);
    }
    (*visit_)(batch_);
}

void RegionField::measure_smooth(double reach) {
    near_films_.clear();
    films_.evaluate_at(batch_.middle());
    for (std::size_t k = 0; k < films_.size(); ++k) {
        const Vec2 middle = 0.5 * (films_.tail(k) + films_.head(k));
        const double far = (batch_.middle() - middle).norm() + reach;
        if (films_.chord(k) > kLeastChord * far) {
            near_films_.push_back(films_.film_functions(k));
            if (is_circle_) {
                near_films_.back().along = {kNowhere, 0.0F, 0.0F, 0.0F};
            }
        }
    }
    batch_.measure_smooth(near_films_);
}

}  // namespace foam::texgen
