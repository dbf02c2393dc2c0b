// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/untangle.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace foam {

// In Tutte's embedding, every junction is at the mean of its neighbors (W. T. Tutte, How to draw a
// graph, Proceedings of the London Mathematical Society 13, 1963). The embedding is the solution of
// a linear system, which is not solved exactly here. Instead, sweeps of Gauss-Seidel move only the
// junctions near tangled ones, so that the rest of the foam keeps its shape. This restriction is
// our own. Tutte's theorem assumes a fixed convex outline. The moved junctions need not have one,
// so that success is not guaranteed. Relaxation (E4), which follows, needs no exact solution.

namespace {

// Largest number of films between a tangled junction (is_tangled) and a junction moved with it.
constexpr int kReach = 2;
// The number of times that each of these junctions is moved. In a test, each of a thousand tangled
// foams reached equilibrium with this number.
constexpr int kSweeps = 20;
constexpr double kNoLength = 1e-9;  // in foam units; a shorter chord counts as zero
// A negative angle of at most this magnitude, in radians, is a rounding error of the angle 0 and
// does not stand for almost a full turn. Such angles occur because the two chords of a two-sided
// bubble have the same direction.
constexpr double kSameAngle = 1e-9;

// Returns the clockwise angle from a to b, in [0, 2 pi) except for rounding errors.
double clockwise_angle(const Vec2& a, const Vec2& b) {
    const double angle = ieee::atan2(cross(b, a), a.dot(b));
    return angle < -kSameAngle ? angle + 2.0 * std::numbers::pi : angle;
}

std::vector<JunctionId> tangled_junctions(const Foam& foam) {
    std::vector<JunctionId> tangled;
    for (const JunctionId junction : foam.network.junctions()) {
        if (is_tangled(foam, junction)) {
            tangled.push_back(junction);
        }
    }
    return tangled;
}

// Appends the neighbors of a junction that are not yet visited, and marks them as visited.
void take_neighbors(const Network& network,
                    JunctionId junction,
                    Indexed<JunctionId, std::uint8_t>& visited,
                    std::vector<JunctionId>& junctions) {
    for (const HalfEdgeId h : network.leaving(junction)) {
        const JunctionId neighbor = network.head(h);
        if (visited[neighbor] == 0) {
            visited[neighbor] = 1;
            junctions.push_back(neighbor);
        }
    }
}

// Returns the given junctions, followed by the junctions up to kReach films away.
std::vector<JunctionId> within_reach(const Network& network, std::vector<JunctionId> junctions) {
    Indexed<JunctionId, std::uint8_t> visited(network.junction_slots(), 0);
    for (const JunctionId junction : junctions) {
        visited[junction] = 1;
    }
    std::size_t next = 0;
    for (int films = 0; films < kReach; ++films) {
        for (const std::size_t end = junctions.size(); next < end; ++next) {
            take_neighbors(network, junctions[next], visited, junctions);
        }
    }
    return junctions;
}

bool is_at_ghost(const Network& network, JunctionId junction) {
    const std::array<HalfEdgeId, 3> leaving = network.leaving(junction);
    return std::any_of(leaving.begin(), leaving.end(), [&](HalfEdgeId h) {
        return network.left(h) == network.ghost();
    });
}

// Returns the direction in which a film of nonzero length leaves its tail. For an outer film it is
// the tangent, since the arc may leave in a very different direction than its chord.
Vec2 direction_at_tail(const Foam& foam, HalfEdgeId h) {
    return foam.network.is_outer(film_of(h)) ? tangent_at_tail(film_arc(foam, h)) : chord(foam, h);
}

void move_to_mean_of_neighbors(Foam& foam, JunctionId junction) {
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.leaving(junction)) {
        sum += chord(foam, h);
    }
    place_junction(foam, junction, foam.positions[junction] + sum / 3.0);
}

}  // namespace

// Network::leaving returns the films in the clockwise order that they should have. `turn` is the
// sum of the clockwise angles from each film to the next. It is one turn if the films really leave
// in this order, and two turns if they leave in the reversed order.
bool is_tangled(const Foam& foam, JunctionId junction) {
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    std::array<Vec2, 3> directions;
    for (std::size_t k = 0; k < 3; ++k) {
        if (chord(foam, leaving[k]).norm() < kNoLength) {
            return true;
        }
        directions[k] = direction_at_tail(foam, leaving[k]);
    }
    double turn = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        turn += clockwise_angle(directions[k], directions[(k + 1) % 3]);
    }
    return turn > 3.0 * std::numbers::pi;
}

int untangle(Foam& foam) {
    const std::vector<JunctionId> tangled = tangled_junctions(foam);
    std::vector<JunctionId> moving = within_reach(foam.network, tangled);
    std::erase_if(moving, [&](JunctionId junction) { return is_at_ghost(foam.network, junction); });
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (const JunctionId junction : moving) {
            move_to_mean_of_neighbors(foam, junction);
        }
    }
    return static_cast<int>(tangled.size());
}

}  // namespace foam
