// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

namespace foam {

/// Finds the index of every entry of the matrix in the panel of its front. Sets `entries` of the
/// plan and the range of each front in them. Precondition: the plan has its fronts and borders.
void locate_entries(const Eigen::SparseMatrix<double>& lower_pattern, FrontPlan& plan);

}  // namespace foam
