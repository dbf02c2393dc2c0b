// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/restore_rafts.h"

#include "core/geometry/elementary.h"

#include <cmath>
#include <vector>

// A raft is a connected component of a patch. The code finds the rigid motion that moves a raft
// back. This motion minimizes the sum of the weighted squared distances from the centers of the
// raft's bubbles to their earlier centers. This is the orthogonal Procrustes problem in the plane.
// The weight of a bubble is the total length of its films. The translation matches the weighted
// means of the present and the earlier centers. The rotation angle is atan2(sum of weighted cross
// products, sum of weighted dot products). Each product combines the present and the earlier center
// of a bubble, both relative to their weighted means.

namespace foam {

namespace {

// Returns the distance from the middle of the chord to the mean of all points of the arc, divided
// by half the length of the chord. The result is positive if the mean is on the right of the chord,
// the side to which an arc with a positive half angle bulges. For a half angle a, the result is
// 1/a - cot a.
double bulge(double half_angle) {
    constexpr double kSmall = 1e-3;  // below this, the next term of the series is under 3e-11
    return std::abs(half_angle) < kSmall ? half_angle / 3.0
                                         : 1.0 / half_angle - 1.0 / ieee::tan(half_angle);
}

// Returns the mean of all points of the arc, relative to its tail.
Vec2 mean_of_arc(const FilmArc& arc) {
    return 0.5 * (arc.chord - bulge(arc.half_angle) * turned_left(arc.chord));
}

struct Center {
    Vec2 position{0.0, 0.0};
    double weight = 0.0;  // length of the films of the bubble
};

Center center_of(const Foam& patch, BubbleId bubble) {
    Center center;
    for (const HalfEdgeId h : patch.network.around(bubble)) {
        const FilmArc arc = film_arc(patch, h);
        const double length = arc_length(arc);
        center.position += length * (patch.positions[patch.network.tail(h)] + mean_of_arc(arc));
        center.weight += length;
    }
    center.position /= center.weight;
    return center;
}

// The bubbles of a raft, a connected component of the patch.
using Raft = std::vector<BubbleId>;

// Returns the raft that contains `first`. Sets the flag of each of its bubbles in `seen`.
Raft raft_around(const Network& network, BubbleId first, Indexed<BubbleId, char>& seen) {
    Raft raft{first};
    seen[first] = 1;
    for (std::size_t k = 0; k < raft.size(); ++k) {
        for (const HalfEdgeId h : network.around(raft[k])) {
            const BubbleId neighbor = network.right(h);
            if (neighbor != network.ghost() && seen[neighbor] == 0) {
                seen[neighbor] = 1;
                raft.push_back(neighbor);
            }
        }
    }
    return raft;
}

struct RigidMotion {
    Vec2 old_center{0.0, 0.0};  // center of rotation before the motion
    Vec2 new_center{0.0, 0.0};  // center of rotation after the motion
    double cosine = 1.0;
    double sine = 0.0;

    Vec2 operator()(const Vec2& point) const {
        const Vec2 x = point - old_center;
        return new_center + cosine * x + sine * turned_left(x);
    }
};

// Returns the rigid motion that moves the centers of a raft's bubbles back to their earlier
// centers, by weighted least squares. Bubbles without an earlier center are ignored. If no bubble
// has an earlier center, the raft does not move.
RigidMotion motion_back(const Foam& patch,
                        const Raft& raft,
                        const std::map<BubbleIdentity, Vec2>& earlier_centers) {
    std::vector<std::pair<Center, Vec2>> pairs;
    RigidMotion motion;
    double weight = 0.0;
    for (const BubbleId bubble : raft) {
        const auto earlier = earlier_centers.find(patch.identities[bubble]);
        if (earlier != earlier_centers.end()) {
            const Center now = center_of(patch, bubble);
            pairs.emplace_back(now, earlier->second);
            motion.old_center += now.weight * now.position;
            motion.new_center += now.weight * earlier->second;
            weight += now.weight;
        }
    }
    if (pairs.empty()) {
        return motion;
    }
    motion.old_center /= weight;
    motion.new_center /= weight;
    double dot_sum = 0.0;
    double cross_sum = 0.0;
    for (const auto& [now, earlier] : pairs) {
        dot_sum += now.weight * (now.position - motion.old_center).dot(earlier - motion.new_center);
        cross_sum +=
            now.weight * cross(now.position - motion.old_center, earlier - motion.new_center);
    }
    const double angle = ieee::atan2(cross_sum, dot_sum);
    const auto [sine, cosine] = ieee::sincos(angle);
    motion.cosine = cosine;
    motion.sine = sine;
    return motion;
}

// Moves each junction of the raft once. `moved` has a flag per junction; a junction belongs to
// several bubbles.
void move_raft(Foam& patch, const Raft& raft, const RigidMotion& motion, std::vector<bool>& moved) {
    for (const BubbleId bubble : raft) {
        for (const HalfEdgeId h : patch.network.around(bubble)) {
            const JunctionId junction = patch.network.tail(h);
            if (!moved[index_of(junction)]) {
                moved[index_of(junction)] = true;
                patch.positions[junction] = motion(patch.positions[junction]);
            }
        }
    }
}

}  // namespace

std::map<BubbleIdentity, Vec2> bubble_centers(const Foam& patch) {
    std::map<BubbleIdentity, Vec2> centers;
    for (const BubbleId bubble : patch.network.bubbles()) {
        centers[patch.identities[bubble]] = center_of(patch, bubble).position;
    }
    for (const LoneBubble& bubble : patch.lone_bubbles) {
        centers[bubble.identity] = bubble.center;
    }
    return centers;
}

EquilibriumSummary equilibrate_keeping_rafts(Solver solver,
                                             Foam& foam,
                                             const EquilibriumOptions& options) {
    if (foam.network.ghost() == kNone<BubbleId>) {
        return equilibrate_with(solver, foam, options);
    }
    const std::map<BubbleIdentity, Vec2> earlier_centers = bubble_centers(foam);
    const EquilibriumSummary summary = equilibrate_with(solver, foam, options);
    compact(foam);  // torn films and closed holes may have left dead slots
    if (summary.converged()) {
        restore_rafts(foam, earlier_centers);
    }
    return summary;
}

void restore_rafts(Foam& patch, const std::map<BubbleIdentity, Vec2>& earlier_centers) {
    Indexed<BubbleId, char> seen(patch.network.bubble_slots(), 0);
    std::vector<bool> moved(patch.network.junction_slots(), false);
    for (const BubbleId bubble : patch.network.bubbles()) {
        if (seen[bubble] == 0) {
            const Raft raft = raft_around(patch.network, bubble, seen);
            move_raft(patch, raft, motion_back(patch, raft, earlier_centers), moved);
        }
    }
    for (LoneBubble& bubble : patch.lone_bubbles) {
        const auto earlier = earlier_centers.find(bubble.identity);
        bubble.center = earlier != earlier_centers.end() ? earlier->second : bubble.center;
    }
}

}  // namespace foam
