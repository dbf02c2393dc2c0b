// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/linear_solver.h"

#include "core/geometry/splitmix64.h"
#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <array>
#include <span>

namespace foam {

namespace {

// The memory limit of a factor is kMaxBytesPerRow for each row, plus the constant
// kMaxBytesOfFewRows. Factors of foams of 1,000 to 100,000 bubbles take up to 1,100 bytes per row
// in double precision. The constant is enough for a dense factor of a small foam. The limit is only
// a safeguard. Bad positions of the solver's nodes (SolverNode) do not make a factor exceed it,
// because positions only guide the order of elimination. Even random positions do not make a factor
// much larger. The solver rejects separators of too many rows, and then divides the graph by its
// edges alone (core/sparse/README.md).
constexpr std::size_t kMaxBytesPerRow = 2000;
constexpr std::size_t kMaxBytesOfFewRows = std::size_t{32} << 20U;  // 32 MiB

std::size_t max_bytes(const Eigen::SparseMatrix<double>& matrix) {
    return kMaxBytesOfFewRows + kMaxBytesPerRow * static_cast<std::size_t>(matrix.rows());
}

// Returns the mean position of the bubble's junctions, wrapped into the fundamental cell of the
// torus.
Vec2 middle_of(const Foam& foam, BubbleId bubble) {
    const Vec2 start = foam.positions[foam.network.tail(foam.network.first(bubble))];
    Vec2 from_start = Vec2::Zero();
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        sum += from_start;
        from_start += chord(foam, h);
    }
    const Vec2 middle = start + sum / foam.network.sides(bubble);
    return middle - foam.domain.translation(foam.domain.cell_of(middle));
}

// Returns a hash of a list of numbers. If two nodes have the same hash, one of them may get a part
// of the dissection that does not suit it. The order of elimination is then valid, but factors in
// single precision may be less accurate.
std::uint64_t name_of(std::span<const std::uint64_t> numbers) {
    std::uint64_t name = 0;
    for (const std::uint64_t number : numbers) {
        name = splitmix64(name ^ number);
    }
    return name;
}

// Returns a hash of the three bubbles around a junction, which changes at a T1.
std::uint64_t name_of(const Foam& foam, JunctionId junction) {
    std::array<std::uint64_t, 3> identities{};
    std::size_t k = 0;
    for (const HalfEdgeId h : foam.network.leaving(junction)) {
        identities.at(k++) = foam.identities[foam.network.left(h)];
    }
    std::ranges::sort(identities);
    return name_of(identities);
}

std::uint64_t name_of(const Foam& foam, BubbleId bubble) {
    return name_of(std::array{std::uint64_t{foam.identities[bubble]}});
}

// Returns a hash of the bubble inside an outer film and of the ends of the film, since a bubble may
// have several outer films.
std::uint64_t outer_film_name(const Foam& foam, FilmId film) {
    HalfEdgeId h = forward_side(film);
    if (foam.network.left(h) == foam.network.ghost()) {
        h = twin(h);
    }
    return name_of(std::array{std::uint64_t{foam.identities[foam.network.left(h)]},
                              name_of(foam, foam.network.tail(h)),
                              name_of(foam, foam.network.head(h))});
}

}  // namespace

std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns) {
    std::vector<SolverNode> nodes;
    nodes.reserve(unknowns.junctions.size() + unknowns.bubbles.size() +
                  unknowns.outer_films.size());
    for (const JunctionId junction : unknowns.junctions) {
        nodes.push_back({foam.positions[junction], 2, name_of(foam, junction)});
    }
    for (const BubbleId bubble : unknowns.bubbles) {
        nodes.push_back({middle_of(foam, bubble), 1, name_of(foam, bubble)});
    }
    for (const FilmId film : unknowns.outer_films) {
        nodes.push_back({middle_of(foam, film), 1, outer_film_name(foam, film)});
    }
    return nodes;
}

void LinearSolver::start(const Foam& foam,
                         const Unknowns& unknowns,
                         Precision precision,
                         int threads,
                         bool keeps_order) {
    nodes_ = solver_nodes(foam, unknowns);
    domain_ = foam.domain;
    precision_ = precision;
    threads_ = thread_count(threads);
    keeps_order_ = keeps_order;
    analyzed_ = false;
}

bool LinearSolver::factor(const Eigen::SparseMatrix<double>& matrix) {
    const auto factor_with = [&](auto& factors) {
        if (!analyzed_) {
            const LdltOptions options{.max_bytes = max_bytes(matrix), .keeps_order = keeps_order_};
            if (factors.analyze(matrix, nodes_, domain_, options, threads_) ==
                LdltAnalysis::TooLarge) {
                return false;
            }
            analyzed_ = true;
        }
        return factors.factor(matrix, threads_);
    };
    return precision_ == Precision::Single ? factor_with(single_) : factor_with(double_);
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right_hand_side) const {
    return precision_ == Precision::Single ? single_.solve(right_hand_side, threads_)
                                           : double_.solve(right_hand_side, threads_);
}

}  // namespace foam
