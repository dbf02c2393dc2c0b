// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/drift.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam {

namespace {

// Returns the median; for an even number of values, the upper of the two in the middle. Changes the
// order of the values. Precondition: `values` is not empty.
double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Returns the median motion of junctions since `before`, along each axis. Precondition: there is a
// junction.
Vec2 median_motion(const Foam& foam,
                   std::span<const JunctionId> junctions,
                   const Positions& before) {
    std::vector<double> along_x;
    std::vector<double> along_y;
    for (const JunctionId junction : junctions) {
        const Vec2 motion = foam.domain.nearest_copy(foam.positions[junction] - before[junction]);
        along_x.push_back(motion.x());
        along_y.push_back(motion.y());
    }
    return {median(along_x), median(along_y)};
}

// Returns all junctions that films connect with `start`, and marks them as found.
std::vector<JunctionId> raft_of(const Network& network,
                                JunctionId start,
                                Indexed<JunctionId, char>& is_found) {
    is_found[start] = 1;
    std::vector<JunctionId> raft{start};
    for (std::size_t k = 0; k < raft.size(); ++k) {
        for (const HalfEdgeId h : network.leaving(raft[k])) {
            const JunctionId next = network.head(h);
            if (is_found[next] == 0) {
                is_found[next] = 1;
                raft.push_back(next);
            }
        }
    }
    return raft;
}

// Returns the junctions of each raft of a patch: of each connected component of the network.
std::vector<std::vector<JunctionId>> rafts_of(const Network& network) {
    std::vector<std::vector<JunctionId>> rafts;
    Indexed<JunctionId, char> is_found;
    is_found.resize(network.junction_slots(), 0);
    for (const JunctionId start : network.junctions()) {
        if (is_found[start] != 0) {
            continue;
        }
        rafts.push_back(raft_of(network, start, is_found));
    }
    return rafts;
}

void translate_raft(Foam& foam, std::span<const JunctionId> raft, const Vec2& by) {
    if (by != Vec2::Zero()) {
        for (const JunctionId junction : raft) {
            foam.positions[junction] += by;
        }
    }
}

Vec2 center_of(std::span<const JunctionId> raft, const Positions& positions) {
    Vec2 sum = Vec2::Zero();
    for (const JunctionId junction : raft) {
        sum += positions[junction];
    }
    return sum / static_cast<double>(raft.size());
}

// Rotates a raft by minus the median of the angles by which the lines between pairs of its
// junctions have turned. The two junctions of a pair are far apart in the list, so that most lines
// are long.
void undo_rotation(Foam& foam, std::span<const JunctionId> raft, const Positions& before) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < raft.size(); ++k) {
        const JunctionId other = raft[(k + raft.size() / 2) % raft.size()];
        const Vec2 from = before[other] - before[raft[k]];
        const Vec2 to = foam.positions[other] - foam.positions[raft[k]];
        angles.push_back(ieee::atan2(cross(from, to), from.dot(to)));
    }
    const double angle = median(angles);
    if (angle == 0.0) {
        return;
    }
    const Vec2 center = center_of(raft, foam.positions);
    const auto [sine, cosine] = ieee::sincos(-angle);
    for (const JunctionId junction : raft) {
        const Vec2 from = foam.positions[junction] - center;
        foam.positions[junction] =
            center + Vec2(cosine * from.x() - sine * from.y(), sine * from.x() + cosine * from.y());
    }
}

}  // namespace

void undo_drift(Foam& foam, const Positions& before) {
    const std::vector<std::vector<JunctionId>> rafts = rafts_of(foam.network);
    if (rafts.size() == 1) {
        const Vec2 drift = median_motion(foam, rafts.front(), before);
        if (drift != Vec2::Zero()) {
            translate(foam, -drift);
        }
        return;
    }
    for (const std::vector<JunctionId>& raft : rafts) {
        undo_rotation(foam, raft, before);
        translate_raft(foam, raft, -median_motion(foam, raft, before));
    }
}

}  // namespace foam
