#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

/// What counts as a defect, and how much of the foam around it joins its region.
struct DefectOptions {
    double force = 0.1;          // a junction is a defect from this force on, in film tensions ...
    double area = 0.3;           // ... and a bubble from this relative area error on
    int rings = 1;               // of neighbors around the defects
    double largest_share = 0.3;  // of all bubbles: if the regions hold more, there are none
};

/// A connected set of bubbles, in increasing order, outside of which the foam is near equilibrium.
using DefectRegion = std::vector<BubbleId>;

/// Returns the connected regions around all defects, in the order of their first bubbles. Returns
/// none if there is no defect, or if the regions would hold too large a share of the foam.
/// `residual` is the residual of `unknowns`, which are all unknowns of the foam.
std::vector<DefectRegion> find_defect_regions(const Foam& foam,
                                              const Unknowns& unknowns,
                                              const Eigen::VectorXd& residual,
                                              const DefectOptions& options);

}  // namespace foam
