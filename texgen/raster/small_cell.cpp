#include "texgen/raster/small_cell.h"

#include "texgen/raster/measure_batch.h"
#include "texgen/raster/runs.h"

namespace foam::texgen {

bool SmallCell::place(const BubbleSides& sides, const CellPlace& at, const Pixels& pixels) {
    if (pixels.columns > SmallMask::kMostColumns || pixels.rows > SmallMask::kMostRows ||
        !sides_.take(sides, at.first_tail(sides)) ||
        !mask_.fill(
            sides.lanes.front(), at.translation - at.corner, pixels.columns, pixels.wanted)) {
        return false;
    }
    batch_.clear(Vec2(pixels.columns / 2, pixels.rows / 2));
    for (int row = pixels.wanted.begin; row < pixels.wanted.end; ++row) {
        for_each_run_of_bits(mask_.row(row),
                             [&](int begin, int count) { batch_.add_run(begin, row, count); });
    }
    reach_ = 0.5 * Vec2(pixels.columns, pixels.rows).norm();
    return true;
}

const PixelBatch& SmallCell::measure(DistanceNeeds needs) {
    if (batch_.is_empty()) {
        return batch_;
    }
    films_.clear();
    for (std::size_t k = 0; needs.smooth && k < sides_.size(); ++k) {
        films_.push_back(sides_.arc(k));
    }
    texgen::measure(sides_, {films_}, reach_, needs, batch_);
    return batch_;
}

}  // namespace foam::texgen
