// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/hold_rafts.h"

#include <cmath>
#include <vector>

// Finds the rigid motion of each raft, a connected component of bubbles, that minimizes the
// weighted squared distances from the centers of its bubbles to their earlier centers: the
// orthogonal Procrustes problem in the plane. The translation matches the weighted means; the
// rotation angle is atan2(sum of cross products, sum of dot products) of the centers relative to
// the means. The weight of a bubble is the length of its films.

namespace foam {

namespace {

// Returns the distance from the middle of the chord to the mean of all points of the arc, divided
// by half of the chord and positive on the side of the bulge: 1 / a - cot a for a half angle a.
double bulge(double half_angle) {
    constexpr double kSmall = 1e-3;  // below, the next term of the series is under 1e-11
    return std::abs(half_angle) < kSmall ? half_angle / 3.0
                                         : 1.0 / half_angle - 1.0 / std::tan(half_angle);
}

// Returns the mean of all points of the arc, relative to its tail.
Vec2 mean_of_arc(const FilmArc& arc) {
    return 0.5 * (arc.chord - bulge(arc.half_angle) * turned_left(arc.chord));
}

struct Center {
    Vec2 at{0.0, 0.0};
    double weight = 0.0;  // length of the films of the bubble
};

Center center_of(const Foam& patch, BubbleId bubble) {
    Center center;
    for (const HalfEdgeId h : patch.network.around(bubble)) {
        const FilmArc arc = film_arc(patch, h);
        const double length = arc_length(arc);
        center.at += length * (patch.positions[patch.network.tail(h)] + mean_of_arc(arc));
        center.weight += length;
    }
    center.at /= center.weight;
    return center;
}

// The bubbles of a raft, a connected component of the patch.
using Raft = std::vector<BubbleId>;

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
    Vec2 from{0.0, 0.0};  // center of rotation before the motion
    Vec2 to{0.0, 0.0};    // center of rotation after the motion
    double cosine = 1.0;
    double sine = 0.0;

    Vec2 operator()(const Vec2& point) const {
        const Vec2 x = point - from;
        return to + cosine * x + sine * turned_left(x);
    }
};

// Returns the rigid motion that fits the centers of the raft to the earlier ones by least squares.
// Bubbles without an earlier center do not count.
RigidMotion motion_back(const Foam& patch,
                        const Raft& raft,
                        const std::map<BubbleIdentity, Vec2>& before) {
    std::vector<std::pair<Center, Vec2>> pairs;
    RigidMotion motion;
    double weight = 0.0;
    for (const BubbleId bubble : raft) {
        const auto then = before.find(patch.identities[bubble]);
        if (then != before.end()) {
            const Center now = center_of(patch, bubble);
            pairs.emplace_back(now, then->second);
            motion.from += now.weight * now.at;
            motion.to += now.weight * then->second;
            weight += now.weight;
        }
    }
    if (pairs.empty()) {
        return motion;
    }
    motion.from /= weight;
    motion.to /= weight;
    double along = 0.0;
    double across = 0.0;
    for (const auto& [now, then] : pairs) {
        along += now.weight * (now.at - motion.from).dot(then - motion.to);
        across += now.weight * cross(now.at - motion.from, then - motion.to);
    }
    const double angle = std::atan2(across, along);
    motion.cosine = std::cos(angle);
    motion.sine = std::sin(angle);
    return motion;
}

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
        centers[patch.identities[bubble]] = center_of(patch, bubble).at;
    }
    for (const LoneBubble& bubble : patch.lone_bubbles) {
        centers[bubble.identity] = bubble.center;
    }
    return centers;
}

void hold_rafts(Foam& patch, const std::map<BubbleIdentity, Vec2>& before) {
    Indexed<BubbleId, char> seen(patch.network.bubble_slots(), 0);
    std::vector<bool> moved(patch.network.junction_slots(), false);
    for (const BubbleId bubble : patch.network.bubbles()) {
        if (seen[bubble] == 0) {
            const Raft raft = raft_around(patch.network, bubble, seen);
            move_raft(patch, raft, motion_back(patch, raft, before), moved);
        }
    }
    for (LoneBubble& bubble : patch.lone_bubbles) {
        const auto then = before.find(bubble.identity);
        bubble.center = then != before.end() ? then->second : bubble.center;
    }
}

}  // namespace foam
