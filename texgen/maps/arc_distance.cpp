// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include "core/parallel/parallel_for.h"
#include "texgen/maps/grid_positions.h"
#include "texgen/raster/distance/arc_view.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

// The image is divided into square blocks of pixels. Each block is measured with the arcs near it,
// by the same functions that measure the distances of the pixels of a bubble (ArcView, PixelBatch).
// There, only the arcs that a pixel faces count. Here, the boundary of the arcs is open, so both
// ends of each arc count, too.

namespace foam::texgen {

namespace {

constexpr int kBlockSide = 24;  // pixels
// An upper bound of the distance of a pixel of a block from the middle of the block, in pixels.
constexpr double kBlockRadius = 0.5 * std::numbers::sqrt2 * kBlockSide;

// Returns a radius such that the circle around the middle of the chord with this radius contains
// the whole arc. The point of the arc that is farthest from the middle of the chord is an end or
// the middle of the arc.
double radius_around_chord(const PixelArc& arc) {
    const Vec2 middle = halves(arc)[0].chord;
    return std::max(0.5 * arc.chord.norm(), (middle - 0.5 * arc.chord).norm());
}

// An arc of the image, with the square of pixels that are near it.
struct ArcInImage {
    DistanceArc arc;
    Vec2 center;    // center of the square, in pixels of the image
    double extent;  // half the side of the square
};

// Returns the arcs and all of their periodic copies whose squares overlap the image, and some
// copies near the image. Wide arcs are cut in halves (DistanceArc::kMinCosine). The square of an
// arc contains all points that are at most `reach` pixels from it.
std::vector<ArcInImage> arcs_in_image(std::span<const PlacedArc> arcs,
                                      const RasterGrid& grid,
                                      const Domain& domain,
                                      double reach) {
    std::vector<ArcInImage> in_image;
    std::vector<DistanceArc> parts;
    for (const PlacedArc& placed : arcs) {
        const double radius = radius_around_chord(placed.arc);
        for_each_copy(grid, domain, placed.tail, reach + 2.0 * radius, [&](const Vec2& tail) {
            parts.clear();
            add_narrow_arcs({tail / kSubpixel, placed.arc, false}, parts);
            for (const DistanceArc& part : parts) {
                in_image.push_back({part,
                                    part.tail + 0.5 * part.shape.chord,
                                    radius_around_chord(part.shape) + reach});
            }
        });
    }
    return in_image;
}

// The rows or the columns [begin, end) of pixels that the image shows of a block, and the middle of
// the whole block.
struct BlockRange {
    int begin;
    int end;
    double middle;
};

// Divides the rows or the columns of an image into blocks. `size` is the number of rows or columns.
// The blocks are those of the unshifted grid (RasterGrid), so that a shift does not change the
// positions of pixels relative to the middle of their block.
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

// Measures the pixels of blocks. Keeps its memory from block to block.
class BlockMeasure {
  public:
    BlockMeasure(const ArcDistanceNeeds& needs, ArcDistances& distances)
        : needs_(needs), distances_(distances) {}

    // Measures a block of pixels. `arcs` contains all arcs that are within reach of its pixels.
    void measure(const BlockRange& columns,
                 const BlockRange& rows,
                 std::span<const DistanceArc> arcs) {
        find_near(arcs, Vec2(columns.middle, rows.middle));
        batch_.clear(Vec2(columns.middle, rows.middle));
        for (int y = rows.begin; y < rows.end; ++y) {
            batch_.add_span(columns.begin, y, columns.end - columns.begin);
        }
        batch_.measure(near_, ends_, needs_.gradient);
        for (const PixelBatch::Span& span : batch_.spans()) {
            write(span);
        }
    }

  private:
    // Finds the arcs and the ends of arcs that may be nearest to a pixel within its reach.
    void find_near(std::span<const DistanceArc> arcs, const Vec2& middle) {
        near_.clear();
        ends_.clear();
        view_.evaluate(arcs, middle);
        const double limit = std::min(view_.horizon(kBlockRadius),
                                      needs_.reach + kBlockRadius + PixelBatch::kMargin);
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            if (arcs[k].shape.chord.norm() > kShortestChord) {
                if (!view_.is_within(k, limit)) {
                    continue;
                }
                near_.push_back(view_.arc_functions(k));
            }
            for (const Vec2& end : {Vec2(arcs[k].tail - middle), Vec2(arcs[k].head() - middle)}) {
                if (end.norm() <= limit) {
                    ends_.push_back(end);
                }
            }
        }
    }

    // Writes the results of the pixels within reach. Those of the others are already set.
    void write(const PixelBatch::Span& span) {
        const auto reach = static_cast<float>(needs_.reach);
        for (std::uint32_t k = 0; k < span.count; ++k) {
            const float distance = batch_.distance()[span.first + k];
            if (distance > reach) {
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

    ArcDistanceNeeds needs_;
    ArcDistances& distances_;
    ArcView view_;
    PixelBatch batch_;
    std::vector<ArcFunctions> near_;
    std::vector<Vec2> ends_;
};

// Measures the pixels of one row of blocks.
void measure_row_of_blocks(std::span<const ArcInImage> arcs,
                           std::span<const BlockRange> columns,
                           const BlockRange& rows,
                           BlockMeasure& measure) {
    std::vector<std::vector<DistanceArc>> arcs_of_block(columns.size());
    for (const ArcInImage& arc : arcs) {
        if (arc.center.y() + arc.extent < rows.begin || arc.center.y() - arc.extent > rows.end) {
            continue;
        }
        const auto first =
            std::ranges::lower_bound(columns, arc.center.x() - arc.extent, {}, &BlockRange::end);
        for (auto block = first;
             block != columns.end() && block->begin <= arc.center.x() + arc.extent;
             ++block) {
            arcs_of_block[static_cast<std::size_t>(block - columns.begin())].push_back(arc.arc);
        }
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (!arcs_of_block[k].empty()) {
            measure.measure(columns[k], rows, arcs_of_block[k]);
        }
    }
}

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
    const std::vector<ArcInImage> in_image = arcs_in_image(arcs, grid, domain, needs.reach);
    const std::vector<BlockRange> columns = block_ranges(grid.width, grid.shift_x);
    const std::vector<BlockRange> rows = block_ranges(grid.height, grid.shift_y);
    std::vector<BlockMeasure> workers(static_cast<std::size_t>(thread_count(threads)),
                                      BlockMeasure(needs, distances));
    parallel_for(static_cast<int>(rows.size()), workers, [&](BlockMeasure& measure, int k) {
        measure_row_of_blocks(in_image, columns, rows[static_cast<std::size_t>(k)], measure);
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
