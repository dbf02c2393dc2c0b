// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/shear_modulus.h"

#include "core/dynamics/shear.h"
#include "core/equilibrium/newton.h"
#include "core/foam/measure.h"
#include "core/foam/stress.h"

namespace foam {

namespace {

// The strain by which the central difference shears the foam to either side. The truncation error
// is proportional to the square of this strain. The effect of the tolerance of Newton's method is
// proportional to the inverse of this strain.
constexpr double kStrain = 1e-4;
// The final residual of Newton's method must be below this value. In large foams, rounding errors
// keep the residual above the tolerance of Newton's method.
constexpr double kConverged = 1e-9;
// The errors of the given foam must be below this value, so that it is in equilibrium.
constexpr double kEquilibrium = 1e-3;

// Returns the shear stress of a copy of the foam that is sheared and brought to equilibrium.
std::optional<double> sheared_stress(Foam foam, double strain, NewtonSystem& system) {
    shear(foam, strain);
    const NewtonOptions options{.force_tolerance = 1e-12,
                                .area_tolerance = 1e-12,
                                .thresholds = {.t1_distance = 0.0, .t2_area = 0.0}};
    const double residual = newton(foam, system, options).residual;
    if (!(residual < kConverged)) {  // also if it is NaN
        return std::nullopt;
    }
    return mean_stress(snapshot(foam, 1))(0, 1);
}

}  // namespace

std::optional<double> shear_modulus(const Foam& foam, int threads) {
    if (foam.domain.is_plane() || !equilibrium_errors(foam).are_below(kEquilibrium)) {
        return std::nullopt;
    }
    NewtonSystem system;
    system.start(foam, all_unknowns(foam.network), threads);
    const std::optional<double> right = sheared_stress(foam, kStrain, system);
    const std::optional<double> left = sheared_stress(foam, -kStrain, system);
    return right && left ? std::optional((*right - *left) / (2.0 * kStrain)) : std::nullopt;
}

std::optional<double> shear_modulus(const Frame& frame, int threads) {
    return shear_modulus(foam_of(frame), threads);
}

}  // namespace foam
