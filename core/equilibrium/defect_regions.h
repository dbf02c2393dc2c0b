// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

/// Thresholds that decide which junctions and bubbles are defects (far from equilibrium), and the
/// size of the regions around the defects.
struct DefectOptions {
    // A junction is a defect if the force on it is at least this number of film tensions.
    double force = 0.1;
    // A bubble is a defect if the magnitude of its relative area error is at least this number.
    double area = 0.3;
    int rings = 1;  // number of rings of neighbors around the defects
    // No region is returned if the regions would contain more than this share of all bubbles.
    double largest_fraction = 0.3;
};

/// A connected set of bubbles around defects that is solved or relaxed on its own. The bubbles are
/// listed by increasing id.
using DefectRegion = std::vector<BubbleId>;

/// Returns the connected regions around all defects, by increasing id of their first bubbles.
/// Returns no region if there is no defect, or if the regions would contain more than
/// `largest_fraction` of the bubbles. Precondition: `unknowns` are all unknowns of the foam, and
/// `residual` is their residual.
std::vector<DefectRegion> find_defect_regions(const Foam& foam,
                                              const Unknowns& unknowns,
                                              const Eigen::VectorXd& residual,
                                              const DefectOptions& options);

}  // namespace foam
