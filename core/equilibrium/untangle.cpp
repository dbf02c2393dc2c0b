#include "core/equilibrium/untangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace foam {

namespace {

constexpr int kReach = 2;            // films from a tangled junction to those that move with it
constexpr int kSweeps = 20;          // no state among a thousand needed more
constexpr double kNoLength = 1e-9;   // foam units
constexpr double kSameAngle = 1e-9;  // radians; the chords of a two-sided bubble are the same

// From a to b, clockwise, in [0, 2 pi) but for rounding.
double clockwise_angle(const Vec2& a, const Vec2& b) {
    const double angle = std::atan2(cross(b, a), a.dot(b));
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

// Adds the neighbours of a junction that are not yet taken.
void take_neighbours(const Network& network,
                     JunctionId junction,
                     Indexed<JunctionId, std::uint8_t>& taken,
                     std::vector<JunctionId>& junctions) {
    for (const HalfEdgeId h : network.leaving(junction)) {
        const JunctionId neighbour = network.head(h);
        if (taken[neighbour] == 0) {
            taken[neighbour] = 1;
            junctions.push_back(neighbour);
        }
    }
}

// The given junctions, then those up to so many films away.
std::vector<JunctionId> within_reach(const Network& network, std::vector<JunctionId> junctions) {
    Indexed<JunctionId, std::uint8_t> taken(network.junction_slots(), 0);
    for (const JunctionId junction : junctions) {
        taken[junction] = 1;
    }
    std::size_t next = 0;
    for (int films = 0; films < kReach; ++films) {
        for (const std::size_t end = junctions.size(); next < end; ++next) {
            take_neighbours(network, junctions[next], taken, junctions);
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

// Of a film that is not without length. An outer film may leave far from its chord.
Vec2 direction_at_tail(const Foam& foam, HalfEdgeId h) {
    return foam.network.is_outer(film_of(h)) ? tangent_at_tail(film_arc(foam, h)) : chord(foam, h);
}

void move_to_mean_of_neighbours(Foam& foam, JunctionId junction) {
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.leaving(junction)) {
        sum += chord(foam, h);
    }
    place_junction(foam, junction, foam.positions[junction] + sum / 3.0);
}

}  // namespace

// Going clockwise from film to film takes one turn, or two where their order is the reverse.
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
            move_to_mean_of_neighbours(foam, junction);
        }
    }
    return static_cast<int>(tangled.size());
}

}  // namespace foam
