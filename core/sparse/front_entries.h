// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

namespace foam {

/// Finds, for every entry of the matrix, its index in the panel of its front. The panel of a Front
/// consists of the columns that the front eliminates. `lower_pattern` is the lower triangle of the
/// matrix; its values are not used. Sets FrontPlan::entries, and for each front the range of its
/// entries (Front::entries_begin and entries_end). Preconditions: `lower_pattern` is compressed,
/// and position_of_row, the fronts and the borders of the plan are set.
void locate_entries(const Eigen::SparseMatrix<double>& lower_pattern, FrontPlan& plan);

}  // namespace foam
