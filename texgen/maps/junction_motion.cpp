// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/junction_motion.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace foam::texgen {

namespace {

// Junctions have no identity that lasts from frame to frame, but bubbles do. A junction is
// therefore identified by its corner: the identities of its three bubbles in cyclic order. If
// several junctions of the next frame have the same corner, the nearest one is used. A junction
// whose corner does not exist in the next frame gets the mean motion of its neighbors. These means
// are computed ring by ring. The first ring consists of the neighbors of junctions that were found
// in the next frame. The second ring consists of the neighbors of the first ring, and so on.

using Corner = std::array<BubbleIdentity, 3>;
using Motion = Indexed<JunctionId, std::optional<Vec2>>;

// Returns the identity of a bubble. For the ghost bubble, returns kNoIndex, which is not the
// identity of any other bubble.
BubbleIdentity identity_of(const Frame& frame, BubbleId bubble) {
    return bubble == frame.network.ghost() ? kNoIndex : frame.bubbles[bubble].identity;
}

// Returns the identities of the bubbles at a junction in clockwise order, beginning with the
// smallest identity.
Corner corner_at(const Frame& frame, JunctionId junction) {
    Corner corner{};
    const auto leaving = frame.network.leaving(junction);
    std::transform(leaving.begin(), leaving.end(), corner.begin(), [&](HalfEdgeId h) {
        return identity_of(frame, frame.network.left(h));
    });
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    return corner;
}

std::map<Corner, std::vector<Vec2>> positions_by_corner(const Frame& frame) {
    std::map<Corner, std::vector<Vec2>> positions;
    for (const JunctionId junction : frame.network.junctions()) {
        positions[corner_at(frame, junction)].push_back(frame.positions[junction]);
    }
    return positions;
}

// Returns the shortest displacement from a point to a copy of one of the positions, or nullopt if
// there are no positions.
std::optional<Vec2> shortest_motion(const Domain& domain,
                                    const Vec2& from,
                                    const std::vector<Vec2>& positions) {
    std::optional<Vec2> shortest;
    for (const Vec2& position : positions) {
        const Vec2 displacement = domain.nearest_copy(position - from);
        if (!shortest || displacement.squaredNorm() < shortest->squaredNorm()) {
            shortest = displacement;
        }
    }
    return shortest;
}

// Returns the motion of each junction, or nullopt for a junction whose corner does not exist in the
// next frame.
Motion motion_of_matched(const Frame& frame, const Frame& next) {
    const std::map<Corner, std::vector<Vec2>> positions = positions_by_corner(next);
    Motion motion;
    for (const JunctionId junction : frame.network.junctions()) {
        const auto found = positions.find(corner_at(frame, junction));
        motion.push_back(
            found == positions.end()
                ? std::nullopt
                : shortest_motion(next.domain, frame.positions[junction], found->second));
    }
    return motion;
}

// Returns the mean motion of the neighbors whose motion is known, or nullopt if there are none.
std::optional<Vec2> motion_beside(const Network& network,
                                  const Motion& motion,
                                  JunctionId junction) {
    Vec2 sum = Vec2::Zero();
    int known = 0;
    for (const HalfEdgeId h : network.leaving(junction)) {
        if (const std::optional<Vec2>& beside = motion[network.head(h)]) {
            sum += *beside;
            ++known;
        }
    }
    return known > 0 ? std::optional<Vec2>(sum / known) : std::nullopt;
}

// Sets the motion of each junction whose motion is unknown, but which has a neighbor of known
// motion. Returns false if there is no such junction.
bool spread_motion(const Network& network, Motion& motion) {
    const Motion before = motion;
    bool added = false;
    for (const JunctionId junction : network.junctions()) {
        if (!before[junction]) {
            motion[junction] = motion_beside(network, before, junction);
            added = added || motion[junction];
        }
    }
    return added;
}

}  // namespace

Indexed<JunctionId, Vec2> junction_motion(const Frame& frame, const Frame& next) {
    Motion motion = motion_of_matched(frame, next);
    while (spread_motion(frame.network, motion)) {
    }
    Indexed<JunctionId, Vec2> motions;
    for (const std::optional<Vec2>& displacement : motion) {
        motions.push_back(displacement.value_or(Vec2::Zero()));
    }
    return motions;
}

}  // namespace foam::texgen
