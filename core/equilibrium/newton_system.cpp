// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/newton_system.h"

#include <cmath>
#include <utility>

namespace foam {

namespace {

// The regularization is a number that is added to each diagonal entry of the Hessian, because the
// Hessian is singular. Its null modes are, for example, the translation of the whole foam and, on a
// torus, a common change of all pressures (E3). For junctions and half angles, the number is the
// film tension times one of the two constants below. For pressures, it is minus this constant times
// the sum of 1e-12 and the magnitude of the diagonal entry, which may be 0. The regularization is
// small compared with the stiffness of the softest shear mode of the foam, and large compared with
// rounding errors in the LDLᵀ factor.
constexpr double kSingleRegularization = 1e-6;
constexpr double kDoubleRegularization = 1e-7;

// Systems of fewer unknowns than this are factored in double precision. In a small foam, there may
// be a motion of junctions that no film resists; only the area constraint of a bubble resists it.
// The pressure of this bubble may be eliminated after these junctions. A pivot of the junctions is
// then only as large as the regularization. The pivot of the pressure has about the magnitude of
// the inverse of the regularization. Single precision is not enough for such pivots.
constexpr int kFewUnknowns = 500;

// Subtracts the mean vector of all junctions from the vector of each junction. The vectors are in
// the first rows, two rows per junction.
void remove_mean(Eigen::VectorXd& rows, std::size_t junction_count) {
    const auto junctions = static_cast<Eigen::Index>(junction_count);
    auto vectors = rows.head(2 * junctions).reshaped(2, junctions);
    vectors.colwise() -= Vec2(vectors.rowwise().mean());
}

}  // namespace

void NewtonSystem::start(const Foam& foam, Unknowns unknowns, int threads) {
    network_.reset();
    keeps_order_ = false;
    prepare(foam, std::move(unknowns), threads);
}

void NewtonSystem::start_whole(const Foam& foam, int threads) {
    if (network_ && precision_ == first_precision() && threads_ == threads &&
        network_->is_connected_as(foam.network)) {
        return;
    }
    network_.reset();  // until everything is prepared
    Unknowns unknowns = all_unknowns(foam.network);
    // A repaired order is less accurate if the nodes of outer films appear or vanish. Then, 4 of
    // 2,500 raw patches found no equilibrium.
    keeps_order_ = unknowns.outer_films.size() == unknowns_.outer_films.size();
    prepare(foam, std::move(unknowns), threads);
    network_ = foam.network;
}

void NewtonSystem::prepare(const Foam& foam, Unknowns unknowns, int threads) {
    unknowns_ = std::move(unknowns);
    threads_ = threads;
    is_whole_ = unknowns_.bubbles.size() == foam.network.bubble_count();
    hessian_.emplace(foam.network, unknowns_);
    start_solver(foam, first_precision());
}

Precision NewtonSystem::first_precision() const {
    return unknowns_.size() < kFewUnknowns ? Precision::Double : Precision::Single;
}

void NewtonSystem::start_solver(const Foam& foam, Precision precision) {
    precision_ = precision;
    solver_.start(foam, unknowns_, precision, threads_, keeps_order_);
    has_factor_ = false;
}

bool NewtonSystem::raise_precision(const Foam& foam) {
    if (precision_ == Precision::Double) {
        return false;
    }
    start_solver(foam, Precision::Double);
    return true;
}

Eigen::VectorXd NewtonSystem::step(const Foam& foam, const Eigen::VectorXd& residual) {
    if (!has_factor_) {
        factor(foam);
    }
    if (!has_factor_) {
        return Eigen::VectorXd::Zero(residual.size());
    }
    Eigen::VectorXd step = -solver_.solve(solvable_part(foam, residual));
    if (is_whole_) {
        // Only the regularization determines the translation of the whole foam. Without the
        // following call, rounding errors in the factor of a sheared foam sometimes move the whole
        // foam by half the size of a bubble (NOTES.md).
        remove_mean(step, unknowns_.junctions.size());
    }
    return step;
}

void NewtonSystem::factor(const Foam& foam) {
    hessian_->evaluate(foam, threads_);
    const double regularization =
        precision_ == Precision::Single ? kSingleRegularization : kDoubleRegularization;
    for (int row = 0; row < unknowns_.size(); ++row) {
        double& diagonal = hessian_->diagonal(row);
        const bool is_pressure =
            row >= unknowns_.first_pressure_row() && row < unknowns_.first_angle_row();
        diagonal += is_pressure ? -regularization * (std::abs(diagonal) + 1e-12)
                                : regularization * foam.film_tension;
    }
    has_factor_ = solver_.factor(hessian_->matrix());
}

// Returns the residual without the components that no step can change: the mean force and, on a
// torus, the mean area error. A translation of the whole foam changes no force and no area. On a
// torus, a common change of all pressures changes no force and no area either. Since the Hessian is
// symmetric, no step changes the corresponding components of the residual. These components are
// zero except for rounding errors, which a factor in single precision would concentrate in one
// bubble. Translations of single rafts of a patch, and rotations, are left to the regularization.
// If the system covers only a part of the foam, returns the residual unchanged.
Eigen::VectorXd NewtonSystem::solvable_part(const Foam& foam, Eigen::VectorXd residual) const {
    if (is_whole_) {
        remove_mean(residual, unknowns_.junctions.size());
    }
    if (is_whole_ && foam.network.ghost() == kNone<BubbleId>) {
        auto areas = residual.tail(static_cast<Eigen::Index>(unknowns_.bubbles.size()));
        areas.array() -= areas.mean();
    }
    return residual;
}

}  // namespace foam
