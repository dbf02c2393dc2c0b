// SPDX-License-Identifier: Apache-2.0

#include "core/foam/target_areas.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace foam {

void spread_areas(std::span<double> areas, double ratio) {
    // The indices of the areas, from the smallest area to the largest.
    std::vector<std::size_t> by_size(areas.size());
    std::iota(by_size.begin(), by_size.end(), std::size_t{0});
    std::stable_sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) {
        return areas[a] < areas[b];
    });
    const double last = std::max<double>(1.0, static_cast<double>(by_size.size()) - 1.0);
    for (std::size_t k = 0; k < by_size.size(); ++k) {
        areas[by_size[k]] = ieee::pow(ratio, static_cast<double>(k) / last);
    }
}

void set_target_areas(std::span<double> areas, std::span<const double> field, double ratio) {
    for (std::size_t k = 0; k < field.size(); ++k) {
        areas[k] = ratio > 0.0 ? areas[k] / field[k] : 1.0;
    }
    if (ratio > 0.0) {
        spread_areas(areas, ratio);
    }
    for (std::size_t k = 0; k < field.size(); ++k) {
        areas[k] *= field[k];
    }
}

void scale_to_total(std::span<double> areas, double total) {
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double& area : areas) {
        area *= total / sum;
    }
}

}  // namespace foam
