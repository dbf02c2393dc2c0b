#include "texgen/raster/small_cell.h"

#include "tests/support/sample_foams.h"
#include "texgen/raster/torus_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
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

// Compares what both have of a cell, without its rows below a cut; whether the cell is small.
class Comparison {
  public:
    bool compare(const TorusCell& cell, int cut) {
        const PixelBox box = box_around(cell.extent, {});
        const SubpixelPoint corner{box.left * kSubpixel, box.bottom * kSubpixel};
        const CellPlace at{{}, corner, corner};
        const int begin = std::min(cut, box.rows());
        if (!small_.place(cell.sides, at, {box.columns(), box.rows(), {begin, box.rows()}})) {
            return false;
        }
        Measured ours;
        collect(small_.measure(kAll), ours);
        mask_.reset(box.columns(), box.rows(), begin);
        place_cell(cell.sides, at, crossings_, mask_, region_);
        Measured theirs;
        region_.measure(
            {mask_, 0, box.rows()}, kAll, [&](const PixelBatch& batch) { collect(batch, theirs); });
        EXPECT_EQ(ours, theirs) << "bubble " << index_of(cell.bubble);
        return true;
    }

  private:
    SmallCell small_;
    RowCrossings crossings_;
    CellMask mask_;
    RegionField region_;
};

// Of bubbles of all kinds, those that are cut by a band too; how many were small.
int count_equal(const Frame& frame, int side, int cut) {
    const TorusCells cells(frame, {side, side}, 1);
    Comparison comparison;
    CellGroup group;
    int count = 0;
    for (int band = 0; band < cells.bands(); ++band) {
        std::span<const TorusBubble> bubbles = cells.bubbles(band);
        while (!bubbles.empty()) {
            group.begin(bubbles, cells.films());
            for (const TorusCell& cell : group.cells()) {
                count += comparison.compare(cell, cut) ? 1 : 0;
                bubbles = bubbles.subspan(1);
            }
        }
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
