#pragma once

#include "core/sparse/separator.h"

namespace foam {

/// What decides an order of elimination besides the graph and the positions of its nodes.
struct DissectionOptions {
    int leaf_rows = 16;  // a part with at most this many rows is not divided
    SeparatorOptions separator{};

    // The graph refines the separators that positions propose if the matrix has this many rows or
    // more.
    int least_refined_rows = 60000;

    // A separator that positions propose is rejected if it has more rows than this number times the
    // square root of the rows of its part. The graph alone then divides the part, and both its
    // sides after it. Separators of ordinary foams reach 2.9, and 2.25 once they are refined.
    double heaviest_separator = 4.0;
    double heaviest_refined = 2.5;
};

}  // namespace foam
