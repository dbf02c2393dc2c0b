// SPDX-License-Identifier: Apache-2.0

#include "core/reference/block_step.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/random.h"
#include "tests/core/equilibrium/derivative_foams.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace foam {
namespace {

using Eigen::Index;
using test::full_hessian;

// The rows of the block's unknowns among the unknowns of the foam, and the size of their units.
struct BlockIndices {
    std::vector<int> rows;
    std::vector<double> units;
};

BlockIndices block_indices(const JunctionBlock& block,
                           const Unknowns& unknowns,
                           JunctionId junction) {
    BlockIndices indices;
    const BlockVector one = BlockVector::Ones(block.size());
    for (std::size_t k = 0; k < block.bubbles().size(); ++k) {
        indices.rows.push_back(unknowns.pressure_row(block.bubbles()[k]));
        indices.units.push_back(block.pressure_change(one, k));
    }
    for (const FilmId film : block.outer_films()) {
        indices.rows.push_back(unknowns.angle_row(film));
        indices.units.push_back(1.0);
    }
    for (int axis = 0; axis < 2; ++axis) {
        indices.rows.push_back(unknowns.position_row(junction) + axis);
        indices.units.push_back(block.move(one)[axis]);
    }
    return indices;
}

// Returns the entries of the Hessian for the block's unknowns. The columns are in the units of the
// block.
BlockMatrix entries(const Eigen::MatrixXd& hessian, const BlockIndices& indices) {
    const auto size = static_cast<Index>(indices.rows.size());
    BlockMatrix part(size, size);
    for (Index column = 0; column < size; ++column) {
        for (Index row = 0; row < size; ++row) {
            part(row, column) = hessian(indices.rows.at(static_cast<std::size_t>(row)),
                                        indices.rows.at(static_cast<std::size_t>(column))) *
                                indices.units.at(static_cast<std::size_t>(column));
        }
    }
    return part;
}

// Compares the derivatives of the areas in the block with the Hessian: dL/dp is the target area
// minus the area (E3). The central differences are accurate to 1e-6.
void expect_areas_of_the_hessian(const std::vector<Foam>& foams) {
    JunctionBlock block;
    for (const Foam& foam : foams) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::MatrixXd h = full_hessian(foam, unknowns);
        for (const JunctionId junction : foam.network.junctions()) {
            block.load(foam, junction);
            const BlockMatrix closed = entries(h, block_indices(block, unknowns, junction));
            const BlockMatrix slopes = block_jacobian(block, {});
            for (std::size_t k = 0; k < block.bubbles().size(); ++k) {
                const auto row = static_cast<Index>(k);
                const auto expected = closed.row(row) / foam.target_areas[block.bubbles()[k]];
                EXPECT_LT((slopes.row(row) - expected).norm(), 1e-6 * (1.0 + expected.norm()));
            }
        }
    }
}

TEST(BlockStep, SlopesOfTheAreasAreThoseOfTheHessian) {
    expect_areas_of_the_hessian(test::derivative_foams());
    expect_areas_of_the_hessian(test::derivative_patches());
}

// Let t_k be the unit tangent of film k at the junction, theta_k its direction, and n_k the vector
// t_k turned left. The gradient of L is -T times the sum of the t_k (E3); its derivative is the
// Hessian. If the films turn by dtheta_k, the gradient changes by -T times the sum of the
// n_k dtheta_k. In equilibrium the n_k add up to zero. Up to constants, the angle errors of the
// block are e_0 = theta_0 - theta_2 and e_1 = theta_1 - theta_0, so that the gradient changes by
// -T (n_1 de_1 - n_2 de_0).
TEST(BlockStep, SlopesOfTheAnglesAreThoseOfTheForces) {
    const Foam foam = test::equilibrated_foam(30, 2);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::MatrixXd h = full_hessian(foam, unknowns);
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        const BlockMatrix closed = entries(h, block_indices(block, unknowns, junction));
        const BlockMatrix slopes = block_jacobian(block, {});
        const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
        const Vec2 n1 = turned_left(tangent_at_tail(film_arc(foam, leaving[1])));
        const Vec2 n2 = turned_left(tangent_at_tail(film_arc(foam, leaving[2])));
        const auto forces = foam.film_tension * (n2 * slopes.row(3) - n1 * slopes.row(4));
        const auto expected = closed.bottomRows<2>();
        EXPECT_LT((forces - expected).norm(), 3e-6 * (1.0 + expected.norm()));
    }
}

// Central differences with steps of 0.2 have errors far above the threshold. Halving the steps
// removes these errors.
TEST(BlockStep, HalvesStepsUntilTheDifferencesConverge) {
    const Foam foam = test::bent_foam(12, 0.5, 1);
    JunctionBlock block;
    block.load(foam, JunctionId{4});
    const BlockMatrix exact = block_jacobian(block, {.first_step = 1e-4, .threshold = 1e-9});
    const BlockMatrix coarse = block_jacobian(block, {.first_step = 0.2, .max_halvings = 0});
    EXPECT_GT((coarse - exact).cwiseAbs().maxCoeff(), 1e-3);
    for (const double threshold : {1e-3, 1e-5}) {
        const BlockMatrix halved =
            block_jacobian(block, {.first_step = 0.2, .threshold = threshold, .max_halvings = 20});
        EXPECT_LT((halved - exact).cwiseAbs().maxCoeff(), threshold);
    }
}

// The step leaves an error of half the second derivatives, here of the order of one, times the
// square of the step. The step is up to twice as large as the errors of the block before the step.
TEST(BlockStep, LeavesTheSquareOfTheBlockErrors) {
    Foam foam = honeycomb(4, 4);
    Random random(3);
    for (Vec2& position : foam.positions) {
        const double x = random.uniform();
        const double y = random.uniform();
        position += 0.02 * Vec2(x - 0.5, y - 0.5);
    }
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        const double before = block.constraint_errors(BlockVector::Zero(5)).norm();
        EXPECT_GT(before, 1e-3);
        EXPECT_LT(block.constraint_errors(block_step(block, {})).norm(), 4.0 * before * before);
    }
}

// The same is true for three equal bubbles, whose outer films have half angles of 90 degrees. At
// this angle the derivative of Laplace-Young's law with respect to the half angle is zero, but the
// block is not singular.
TEST(BlockStep, LeavesTheSquareAtNinetyDegreesToo) {
    Foam foam = test::triple_bubble(1.0);
    ASSERT_TRUE(equilibrate(foam, {}).converged());
    Random random(3);
    for (double& angle : foam.half_angles) {
        angle += 0.02 * (random.uniform() - 0.5);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.pressures[bubble] += 0.02 * (random.uniform() - 0.5);
    }
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        const double before = block.constraint_errors(BlockVector::Zero(block.size())).norm();
        EXPECT_GT(before, 1e-3);
        EXPECT_LT(block.constraint_errors(block_step(block, {})).norm(), 4.0 * before * before);
    }
}

// The two bubbles fill the torus, so that their areas do not determine a common pressure. The step
// of minimum norm contains no common pressure. The unit of pressure is 1 for both bubbles.
TEST(BlockStep, IsTheSmallestWhereTheBlockIsSingular) {
    Foam foam = honeycomb(1, 2);
    foam.positions[JunctionId{0}] += Vec2(0.05, 0.02);
    JunctionBlock block;
    block.load(foam, JunctionId{1});
    ASSERT_EQ(block.size(), 4);
    const BlockVector step = block_step(block, {});
    EXPECT_GT(std::abs(step[0]), 1e-3);
    EXPECT_NEAR(step[0] + step[1], 0.0, 1e-6);
    EXPECT_LT(step.norm(), 1.0);
}

TEST(BlockStep, DoesNotDependOnTheTension) {
    Foam soft = test::bent_foam(12, 0.5, 1);
    Foam stiff = soft;
    stiff.film_tension *= 1024.0;  // a power of two changes no rounding
    for (double& pressure : stiff.pressures) {
        pressure *= 1024.0;
    }
    JunctionBlock block;
    block.load(soft, JunctionId{4});
    const BlockVector step = block_step(block, {});
    block.load(stiff, JunctionId{4});
    EXPECT_EQ(block_step(block, {}), step);
}

}  // namespace
}  // namespace foam
