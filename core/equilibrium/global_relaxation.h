// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/relaxation.h"

namespace foam {

/// Options for the relaxation of the whole foam (E4), which is made in one or more passes. A pass
/// makes a given number of sweeps. The limit of the half angle of inner films is 80 degrees (E3).
struct GlobalRelaxationOptions {
    int sweeps = 60;  // sweeps of the first pass
    // Sweeps of each further pass.
    int further_sweeps = 60;
    // If true, the first pass resets pressures and half angles (RelaxationOptions::restarts). If
    // false, the first pass resets them only in three cases:
    // - The foam is tangled.
    // - The foam has films at the limit of their half angle.
    // - The foam is a patch far from equilibrium.
    // A patch is far from equilibrium if its defect regions would be too large
    // (DefectOptions::largest_fraction). It is also far from equilibrium if its only large errors
    // are errors of Laplace-Young's law at outer films, which no defect region contains.
    bool restarts = false;
    TopologyThresholds thresholds{};
    int threads = 0;  // same meaning as in parallel_for
};

/// Untangles the foam and relaxes it, as a start for Newton's method. Further passes follow while a
/// patch is far from equilibrium in the sense of GlobalRelaxationOptions::restarts. They also
/// follow while any film is at the limit of its half angle, if the first pass has left more than
/// ten such films. At most ten further passes are made. Returns the total numbers of sweeps and
/// T1s. Precondition: `memory` was constructed for the same foam.
RelaxationSummary relax_globally(Foam& foam,
                                 const GlobalRelaxationOptions& options,
                                 SoftFoam& memory);

}  // namespace foam
