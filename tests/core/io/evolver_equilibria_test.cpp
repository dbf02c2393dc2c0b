// SPDX-License-Identifier: Apache-2.0

// Reads foams that Surface Evolver brought to equilibrium (tests/data/evolver/README.md) and
// compares them with our equilibria.
#include "core/equilibrium/equilibrate_given.h"
#include "core/foam/measure.h"
#include "core/io/evolver_file.h"
#include "tests/core/foams.h"
#include "tests/core/io/data_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam {
namespace {

constexpr double kEnergyTolerance = 1e-9;    // relative
constexpr double kPressureTolerance = 1e-7;  // for film tension 1 and mean area 1

struct Reference {
    const char* name;
    std::size_t bubbles;
    double energy;  // as computed by Evolver
};

class EvolverEquilibria : public testing::TestWithParam<Reference> {
  protected:
    static Foam read(const char* extension) {
        const std::string name = std::string("evolver/") + GetParam().name + extension;
        return read_evolver(test::data_file(name), name).foam;
    }
};

// Returns the pressure to which other pressures are relative. On a torus, pressures are known only
// up to a constant.
double reference_pressure(const Foam& foam) {
    return foam.domain.is_plane() ? 0.0 : foam.pressures[BubbleId{0}];
}

double largest_pressure_difference(const Foam& a, const Foam& b) {
    double largest = 0.0;
    for (const BubbleId bubble : a.network.bubbles()) {
        const double in_a = a.pressures[bubble] - reference_pressure(a);
        const double in_b = b.pressures[bubble] - reference_pressure(b);
        largest = std::max(largest, std::abs(in_a - in_b));
    }
    return largest;
}

TEST_P(EvolverEquilibria, ADumpIsReadInEquilibrium) {
    const Foam foam = read(".dmp");
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.network.bubble_count(), GetParam().bubbles);
    EXPECT_NEAR(energy(foam), GetParam().energy, 1e-13 * GetParam().energy);
    EXPECT_LT(equilibrium_errors(foam).area, 1e-11);
    EXPECT_LT(equilibrium_errors(foam).angle, 1e-11);
}

TEST_P(EvolverEquilibria, AgreeWithOurs) {
    const Foam reference = read(".dmp");
    Foam foam = read(".fe");
    const EquilibriumSummary summary = equilibrate_given(foam, 0);
    ASSERT_TRUE(summary.converged());
    EXPECT_EQ(summary.t1, 0);
    EXPECT_LT(summary.area_error, 1e-9);
    EXPECT_LT(summary.angle_error, 1e-9);
    EXPECT_NEAR(summary.energy, GetParam().energy, kEnergyTolerance * GetParam().energy);
    EXPECT_LT(largest_pressure_difference(foam, reference), kPressureTolerance);
}

TEST_P(EvolverEquilibria, OursIsWrittenInEquilibrium) {
    Foam foam = read(".fe");
    ASSERT_TRUE(equilibrate_given(foam, 0).converged());
    const Foam again = read_evolver(write_evolver(foam), "again.fe").foam;
    // Half angles of outer films are not written. They are computed from the pressures and differ
    // by rounding errors.
    const double rounding = foam.domain.is_plane() ? 1e-13 * energy(foam) : 0.0;
    EXPECT_NEAR(energy(again), energy(foam), rounding);
    EXPECT_LT(largest_pressure_difference(again, foam), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Clusters,
                         EvolverEquilibria,
                         testing::Values(Reference{"cluster37", 37, 80.173322931159},
                                         Reference{"cluster331", 331, 650.498211523503}),
                         [](const auto& tested) { return std::string(tested.param.name); });

INSTANTIATE_TEST_SUITE_P(Tori,
                         EvolverEquilibria,
                         testing::Values(Reference{"torus64", 64, 120.765667254534},
                                         Reference{"torus1024", 1024, 1920.479549095320}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace foam
