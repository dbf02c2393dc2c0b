// SPDX-License-Identifier: Apache-2.0

#include "core/foam/target_areas.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <numeric>
#include <vector>

// If the target areas are to have a given ratio of the largest to the smallest, their logarithms
// are evenly spaced. They are assigned by rank: the k-th smallest cell gets the k-th smallest
// target area. Of all assignments of the same target areas, this one minimizes the sum of the
// squared changes of log area (rearrangement inequality; Hardy, Littlewood and Polya, Inequalities,
// 1934, chapter 10). The method is our own; core/NOTES.md tells why it is used instead of a
// weighted Voronoi diagram.

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
