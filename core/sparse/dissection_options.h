// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/separator.h"

namespace foam {

/// The parameters of an order of elimination.
struct DissectionOptions {
    int leaf_rows = 16;  // a part with at most this many rows is not divided
    SeparatorOptions separator{};

    // Separators that positions propose are refined along the edges of the graph if the matrix has
    // at least this many rows.
    int min_refined_rows = 60000;

    // A separator that positions propose is rejected if it has more rows than `heaviest_separator`
    // times the square root of the rows of its part. `heaviest_refined` replaces this factor if the
    // separator has been refined. The part and all parts of its subtree are then divided by the
    // graph alone. In ordinary foams the factor reaches 2.9, or 2.25 after refinement.
    double heaviest_separator = 4.0;
    double heaviest_refined = 2.5;
};

}  // namespace foam
