// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include "core/parallel/counting_sort.h"
#include "core/parallel/parallel_for.h"
#include "texgen/maps/grid_positions.h"
#include "texgen/raster/distance/arc_view.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

// The image is divided into square blocks of pixels. Each block is measured with the arcs near it,
// by the classes that also measure the pixels of a bubble (ArcView, PixelBatch). PixelBatch counts
// an arc only for the pixels that face the arc, that is, are between the normals at its two ends or
// at most 0.001 pixels beyond one of them. The arcs here have free ends, so their ends are passed
// to PixelBatch as points. Tails of arcs are rounded to whole numbers of subpixels. Their positions
// relative to the middle of a block are therefore exact, and a shift of the grid changes no bit.

namespace foam::texgen {

namespace {

constexpr int kBlockSide = 16;  // pixels
static_assert(std::size_t{kBlockSide} * kBlockSide <= PixelBatch::kCapacity);
// An upper bound of the distance of a pixel of a block from the middle of the block, in pixels.
constexpr double kBlockRadius = 0.5 * std::numbers::sqrt2 * kBlockSide;
constexpr std::size_t kArcsPerChunk = 4096;

// Returns a radius such that the circle around the middle of the chord with this radius contains
// the whole arc. The point of the arc that is farthest from the middle of the chord is an end or
// the middle of the arc.
double radius_around_chord(const PixelArc& arc) {
    const Vec2 middle = halves(arc)[0].chord;
    return std::max(0.5 * arc.chord.norm(), (middle - 0.5 * arc.chord).norm());
}

// An arc near the image. An arc that turns by more than 120 degrees is stored as several parts,
// each of which is a NearArc.
struct NearArc {
    Vec2 start;        // tail of the whole arc, in pixels of the image; a whole number of subpixels
    DistanceArc part;  // its tail is relative to `start`
    bool has_head;     // true if the part ends at the head of the whole arc
    Vec2 center;       // center of the square around the part (parts_of), in pixels of the image
    double extent;     // half the side of this square
};

// Returns the parts of an arc that begins at the origin: the arc itself, or several parts if it
// turns by more than 120 degrees (add_narrow_arcs). The square of a part contains all points that
// are at most `reach` pixels from the part.
std::vector<NearArc> parts_of(const PixelArc& arc, double reach) {
    std::vector<DistanceArc> shapes;
    add_narrow_arcs({Vec2::Zero(), arc, true}, shapes);
    std::vector<NearArc> parts;
    parts.reserve(shapes.size());
    for (const DistanceArc& part : shapes) {
        // A part turns by at most 120 degrees. Of all its points, the ends are therefore farthest
        // from the middle of its chord. The square around this middle needs only half the chord
        // plus `reach`.
        parts.push_back({Vec2::Zero(),
                         part,
                         parts.size() + 1 == shapes.size(),
                         part.tail + 0.5 * part.shape.chord,
                         0.5 * part.shape.chord.norm() + reach});
    }
    return parts;
}

// Returns the parts of all arcs and of their periodic copies that are near the image.
std::vector<NearArc> arcs_near_image(std::span<const PlacedArc> arcs,
                                     const RasterGrid& grid,
                                     const Domain& domain,
                                     double reach) {
    std::vector<NearArc> near;
    for (const PlacedArc& placed : arcs) {
        const std::vector<NearArc> parts = parts_of(placed.arc, reach);
        const double radius = radius_around_chord(placed.arc);
        for_each_copy(grid, domain, placed.tail, reach + 2.0 * radius, [&](const Vec2& tail) {
            for (NearArc part : parts) {
                part.start = tail / kSubpixel;
                part.center += part.start;
                near.push_back(part);
            }
        });
    }
    return near;
}

// The visible part of a block in one direction: the rows or columns [begin, end) of the image that
// belong to the block. `middle` is the middle of the whole block, including the part outside of the
// image.
struct BlockRange {
    int begin;
    int end;
    double middle;
};

// Divides the rows or the columns of an image into blocks. `size` is the number of rows or columns.
// The blocks are those of the unshifted grid (RasterGrid). A block that the border of a shifted
// image cuts appears twice, with one part at each border.
std::vector<BlockRange> block_ranges(int size, int shift) {
    std::vector<BlockRange> ranges;
    for (int origin = -wrap(shift, size); origin < size; origin += size) {
        for (int first = 0; first < size; first += kBlockSide) {
            const int begin = origin + first;
            const int end = origin + std::min(first + kBlockSide, size);
            if (begin < size && end > 0) {
                ranges.push_back({std::max(begin, 0), std::min(end, size), 0.5 * (begin + end)});
            }
        }
    }
    return ranges;
}

// Calls visit(k) for each range k that overlaps or touches the interval from `center` - `extent` to
// `center` + `extent`.
template <class Visit>
void for_each_range(std::span<const BlockRange> ranges,
                    double center,
                    double extent,
                    const Visit& visit) {
    const auto first = std::ranges::lower_bound(ranges, center - extent, {}, &BlockRange::end);
    for (auto range = first; range != ranges.end() && range->begin <= center + extent; ++range) {
        visit(static_cast<std::size_t>(range - ranges.begin()));
    }
}

// Returns, for each row of blocks, the indices of the arcs whose squares overlap this row.
Buckets<std::uint32_t> sorted_by_row(std::span<const NearArc> arcs,
                                     std::span<const BlockRange> rows,
                                     int threads) {
    const std::size_t chunks = chunk_count(arcs.size(), kArcsPerChunk);
    return counting_sort<std::uint32_t>(
        rows.size(), chunks, threads, [&](std::size_t chunk, const auto& put) {
            const std::size_t end = std::min((chunk + 1) * kArcsPerChunk, arcs.size());
            for (std::size_t k = chunk * kArcsPerChunk; k < end; ++k) {
                for_each_range(rows, arcs[k].center.y(), arcs[k].extent, [&](std::size_t row) {
                    put(row, static_cast<std::uint32_t>(k));
                });
            }
        });
}

// Measures the pixels of blocks. Keeps its memory from block to block.
class BlockMeasure {
  public:
    BlockMeasure(std::span<const NearArc> arcs,
                 const ArcDistanceNeeds& needs,
                 ArcDistances& distances)
        : all_arcs_(arcs), needs_(needs), distances_(distances) {}

    // Measures a row of blocks. `near_row` contains the indices of the arcs near the row.
    void measure_row(std::span<const BlockRange> columns,
                     const BlockRange& rows,
                     std::span<const std::uint32_t> near_row) {
        near_block_.resize(columns.size());
        for (std::vector<std::uint32_t>& near : near_block_) {
            near.clear();
        }
        for (const std::uint32_t k : near_row) {
            for_each_range(
                columns, all_arcs_[k].center.x(), all_arcs_[k].extent, [&](std::size_t column) {
                    near_block_[column].push_back(k);
                });
        }
        for (std::size_t k = 0; k < columns.size(); ++k) {
            measure_block(columns[k], rows, near_block_[k]);
        }
    }

  private:
    void measure_block(const BlockRange& columns,
                       const BlockRange& rows,
                       std::span<const std::uint32_t> near) {
        const Vec2 middle(columns.middle, rows.middle);
        find_nearest(near, middle);
        if (functions_.empty() && ends_.empty()) {
            return;
        }
        batch_.clear(middle);
        for (int y = rows.begin; y < rows.end; ++y) {
            batch_.add_span(columns.begin, y, columns.end - columns.begin);
        }
        batch_.measure(functions_, ends_, needs_.gradient);
        for (const PixelBatch::Span& span : batch_.spans()) {
            write(span);
        }
    }

    // Finds the arcs and the ends that may be nearest to a pixel of the block and within reach of
    // this pixel. ArcView::horizon is a distance from the middle beyond which no arc is the nearest
    // one of a pixel of the block. It holds for ends, too: each pixel is nearer to the nearest arc
    // that the middle faces than to any end beyond the horizon.
    void find_nearest(std::span<const std::uint32_t> near, const Vec2& middle) {
        arcs_.clear();
        functions_.clear();
        ends_.clear();
        for (const std::uint32_t k : near) {
            const NearArc& arc = all_arcs_[k];
            arcs_.push_back(
                {(arc.start - middle) + arc.part.tail, arc.part.shape, arc.part.corner});
        }
        view_.evaluate(arcs_, Vec2::Zero());
        const double limit = std::min(view_.horizon(kBlockRadius),
                                      needs_.reach + kBlockRadius + PixelBatch::kMargin);
        const auto add_end = [&](const Vec2& end) {
            if (end.norm() <= limit) {
                ends_.push_back(end);
            }
        };
        for (std::size_t k = 0; k < near.size(); ++k) {
            if (arcs_[k].shape.chord.norm() > kShortestChord && view_.is_within(k, limit)) {
                functions_.push_back(view_.arc_functions(k));
            }
            if (arcs_[k].corner) {
                add_end(arcs_[k].tail);
            }
            if (all_arcs_[near[k]].has_head) {
                add_end(arcs_[k].head());
            }
        }
    }

    // Writes the results of the pixels within reach. All other pixels keep their initial values.
    void write(const PixelBatch::Span& span) {
        for (std::uint32_t k = 0; k < span.count; ++k) {
            const float distance = batch_.distance()[span.first + k];
            if (static_cast<double>(distance) > needs_.reach) {
                continue;
            }
            const int x = span.column + static_cast<int>(k);
            distances_.distance.pixel(x, span.row)[0] = distance;
            if (needs_.gradient) {
                const auto gradient = distances_.gradient.pixel(x, span.row);
                gradient[0] = batch_.gradient_x()[span.first + k];
                gradient[1] = batch_.gradient_y()[span.first + k];
            }
        }
    }

    std::span<const NearArc> all_arcs_;
    ArcDistanceNeeds needs_;
    ArcDistances& distances_;
    // The indices of the arcs near each block of a row.
    std::vector<std::vector<std::uint32_t>> near_block_;
    std::vector<DistanceArc> arcs_;  // the arcs near a block, relative to its middle
    ArcView view_;
    std::vector<ArcFunctions> functions_;
    std::vector<Vec2> ends_;
    PixelBatch batch_;
};

}  // namespace

ArcDistances distances_to_arcs(std::span<const PlacedArc> arcs,
                               const RasterGrid& grid,
                               const Domain& domain,
                               const ArcDistanceNeeds& needs,
                               int threads) {
    ArcDistances distances{{grid.width, grid.height, 1}, {}};
    if (needs.gradient) {
        distances.gradient = {grid.width, grid.height, 2};
    }
    std::ranges::fill(distances.distance.samples(), std::numeric_limits<float>::infinity());
    const std::vector<NearArc> near = arcs_near_image(arcs, grid, domain, needs.reach);
    const std::vector<BlockRange> columns = block_ranges(grid.width, grid.shift_x);
    const std::vector<BlockRange> rows = block_ranges(grid.height, grid.shift_y);
    const Buckets<std::uint32_t> near_rows = sorted_by_row(near, rows, threads);
    const auto count = static_cast<int>(rows.size());
    std::vector<BlockMeasure> workers(
        static_cast<std::size_t>(std::min(thread_count(threads), count)),
        BlockMeasure(near, needs, distances));
    parallel_for(count, workers, [&](BlockMeasure& measure, int k) {
        const auto row = static_cast<std::size_t>(k);
        measure.measure_row(columns, rows[row], near_rows.items_of(row, row + 1));
    });
    return distances;
}

ArcDistanceNeeds stroke_needs(double width) {
    return {.reach = 0.5 * std::max(width, 1.0) + 1.0};
}

Image<float> stroke_coverage(Image<float> distance, double width) {
    const double half_width = 0.5 * std::max(width, 1.0);
    const double strength = std::min(width, 1.0);
    for (float& sample : distance.samples()) {
        const double inside = half_width - static_cast<double>(sample);
        sample = static_cast<float>(strength * std::clamp(0.5 + inside, 0.0, 1.0));
    }
    return distance;
}

}  // namespace foam::texgen
