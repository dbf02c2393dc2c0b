#pragma once

#include "core/sparse/separator.h"

namespace foam {

struct DissectionOptions {
    int leaf_rows = 16;  // a part with at most this many rows is not divided
    SeparatorOptions separator{};

    // With this many rows and more, the separators that positions propose are refined by the graph.
    int least_refined_rows = 60000;

    // In rows, per square root of the rows of the part. If the separator that positions propose has
    // more, the part and all that is left of it are divided by the graph alone. Separators of
    // ordinary foams have up to 2.9, and up to 2.25 once they are refined.
    double heaviest_separator = 4.0;
    double heaviest_refined = 2.5;
};

}  // namespace foam
