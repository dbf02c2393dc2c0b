#include "texgen/raster/small_cell.h"

#include "texgen/raster/runs.h"
#include "texgen/raster/smooth_films.h"

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
    const bool gradient = needs.gradient || needs.smooth;
    sides_.measure(reach_, gradient, batch_);
    if (gradient) {
        batch_.normalize_gradients();
    }
    if (needs.smooth) {
        films_.clear();
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            films_.push_back(sides_.arc(k));
        }
        measure_smooth(films_, false, reach_, batch_);
    }
    return batch_;
}

}  // namespace foam::texgen
