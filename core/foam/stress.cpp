// SPDX-License-Identifier: Apache-2.0

#include "core/foam/stress.h"

namespace foam {

// A lone bubble of radius r and pressure T / r contributes nothing to the sum. To each diagonal
// entry, its circle contributes pi r T, and its gas -pi r² T / r.
Mat2 mean_stress(const Frame& frame) {
    Mat2 sum = Mat2::Zero();
    for (const FilmArc& arc : frame.arcs) {
        sum += frame.film_tension * tangent_tensor(arc);
    }
    double area = 0.0;
    for (const FrameBubble& bubble : frame.bubbles) {
        sum -= bubble.pressure * bubble.area * Mat2::Identity();
        area += bubble.area;
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        area += bubble.target_area;
    }
    return area > 0.0 ? Mat2(sum / area) : Mat2::Zero();
}

}  // namespace foam
