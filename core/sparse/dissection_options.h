// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam {

/// The parameters of nested dissection (dissect).
struct DissectionOptions {
    int leaf_rows = 16;  // a part with at most this many rows is not divided

    // Separators that were found from positions are refined along the edges of the graph
    // (SeparatorRefinement) if the part that they divide has at least this many rows.
    int min_refined_rows = 40;

    // A separator that was found from positions is rejected if its relative weight exceeds a limit.
    // The relative weight is the number of rows of the separator, divided by the square root of the
    // number of rows of the divided part. The limit is `heaviest_separator` before refinement, and
    // `heaviest_refined` after it. If a separator is rejected, the part and all parts that result
    // from its division are divided without positions. Their separators are then found from the
    // edges of the graph alone.
    double heaviest_separator = 5.0;
    double heaviest_refined = 2.5;
};

}  // namespace foam
