#include "core/equilibrium/linear_solver.h"

#include <thread>

namespace foam {

namespace {

Vec2 middle_of(const Foam& foam, BubbleId bubble) {
    const Vec2 start = foam.positions[foam.network.tail(foam.network.first(bubble))];
    Vec2 from_start = Vec2::Zero();
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        sum += from_start;
        from_start += chord(foam, h);
    }
    const Vec2 middle = start + sum / foam.network.sides(bubble);
    return middle - foam.torus.translation(foam.torus.cell_of(middle));
}

}  // namespace

std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns) {
    std::vector<SolverNode> nodes;
    nodes.reserve(unknowns.junctions.size() + unknowns.bubbles.size());
    for (const JunctionId junction : unknowns.junctions) {
        nodes.push_back({foam.positions[junction], 2});
    }
    for (const BubbleId bubble : unknowns.bubbles) {
        nodes.push_back({middle_of(foam, bubble), 1});
    }
    return nodes;
}

LinearSolver::LinearSolver(const Foam& foam, const Unknowns& unknowns, int threads)
    : nodes_(solver_nodes(foam, unknowns)),
      torus_(foam.torus),
      threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {}

bool LinearSolver::factor(const Eigen::SparseMatrix<double>& matrix) {
    if (!analyzed_) {
        factors_.analyze(matrix, nodes_, torus_);
        analyzed_ = true;
    }
    return factors_.factor(matrix, threads_);
}

}  // namespace foam
