#include "texgen/raster/small_cell.h"

#include "tests/support/raster_frames.h"
#include "texgen/raster/torus_cells.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

constexpr DistanceNeeds kAll{.gradient = true, .smooth = true};

// Of each pixel: its distance and smooth distance, and their gradients.
using Measured = std::map<std::pair<int, int>, std::vector<float>>;

void collect(const PixelBatch& batch, Measured& pixels) {
    for (const PixelBatch::Run& run : batch.runs()) {
        for (std::size_t k = 0; k < run.count; ++k) {
            const std::size_t at = run.first + k;
            pixels[{run.column + static_cast<int>(k), run.row}] = {batch.distance()[at],
                                                                   batch.gradient_x()[at],
                                                                   batch.gradient_y()[at],
                                                                   batch.smooth()[at],
                                                                   batch.smooth_x()[at],
                                                                   batch.smooth_y()[at]};
        }
    }
}

// Bubbles of all kinds, those that are cut by a band too; how many were small.
int count_equal(const Frame& frame, int side, int cut) {
    const RasterGrid grid{side, side};
    const TorusCells cells(frame, grid, 1);
    SmallCell small;
    RowCrossings crossings;
    CellMask mask;
    RegionField region;
    int count = 0;
    for (std::size_t k = 0; k < cells.bubbles().size(); ++k) {
        const PixelBox box = box_around(cells.extents()[k], {});
        const SubpixelPoint corner{box.left * kSubpixel, box.bottom * kSubpixel};
        const CellPlace at{{}, corner, corner};
        const int begin = std::min(cut, box.rows());
        const BubbleSides sides = cells.sides(k);
        if (!small.place(sides, at, {box.columns(), box.rows(), {begin, box.rows()}})) {
            continue;
        }
        Measured ours;
        collect(small.measure(kAll), ours);
        mask.reset(box.columns(), box.rows(), begin);
        place_cell(sides, at, crossings, mask, region);
        Measured theirs;
        region.measure(
            {mask, 0, box.rows()}, kAll, [&](const PixelBatch& batch) { collect(batch, theirs); });
        EXPECT_EQ(ours, theirs) << "bubble " << k;
        ++count;
    }
    return count;
}

TEST(SmallCell, HasTheBitsOfARegionField) {
    const Frame bent = test::fitted_frame(test::bent_foam(60, 0.4, 3), 120, 120);
    EXPECT_GT(count_equal(bent, 120, 0), 40);
    EXPECT_GT(count_equal(bent, 120, 7), 40);
    const Frame tiny = test::fitted_frame(test::bent_foam(300, 0.3, 6), 20, 20);
    EXPECT_GT(count_equal(tiny, 20, 0), 200);
    const Frame mixed = test::fitted_frame(test::polydisperse_foam(60, 5), 150, 150);
    EXPECT_GT(count_equal(mixed, 150, 0), 20);
}

}  // namespace
}  // namespace foam::texgen
