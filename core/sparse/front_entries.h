#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

namespace foam {

/// Finds the place of every number of the matrix among the fronts' panels: sets `entries` of the
/// plan and the range of each front among them. The plan has its fronts and borders already.
void place_entries(const Eigen::SparseMatrix<double>& lower_pattern, FrontPlan& plan);

}  // namespace foam
