// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/new_bubble.h"

#include "core/dynamics/nucleation.h"
#include "core/foam/corners.h"
#include "core/foam/locate.h"

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr int kMaxTries = 100;
constexpr double kFirstAreaFactor = 2.0;  // initial target area of a new bubble, in T2 areas

// Returns a random point of the torus, or of the bounding box of the patch's junctions.
Vec2 random_point(const Foam& foam, Random& random) {
    const double x = random.uniform();
    const double y = random.uniform();
    if (!foam.domain.is_plane()) {
        return {x * foam.domain.width, y * foam.domain.height};
    }
    const Box box = box_around_junctions(foam);
    return box.low + Vec2(x, y).cwiseProduct(box.size());
}

}  // namespace

std::optional<BubbleId> nucleate_near(NucleationSite site,
                                      const Vec2& point,
                                      double area,
                                      Foam& foam) {
    if (!bubble_at(foam, point)) {
        return std::nullopt;
    }
    if (site == NucleationSite::Junction) {
        return nucleate_at_junction(foam, nearest_junction(foam, point), area);
    }
    return nucleate_on_film(foam, nearest_film(foam, point), area);
}

std::optional<BubbleId> nucleate_anywhere(NucleationSite site,
                                          double area,
                                          Random& random,
                                          Foam& foam) {
    for (int k = 0; k < kMaxTries; ++k) {
        const Vec2 point = random_point(foam, random);
        if (const auto bubble = nucleate_near(site, point, area, foam)) {
            return bubble;
        }
    }
    return std::nullopt;
}

double first_area(double area, double t2_area) {
    return std::min(area, kFirstAreaFactor * t2_area);
}

void grow_bubble(const Foam& foam,
                 BubbleId bubble,
                 const FrameSpan& frames,
                 double area,
                 DrivenSchedules& schedules) {
    schedules[foam.identities[bubble]] = {
        frames, {.from = foam.target_areas[bubble], .to = area}, false};
}

}  // namespace foam::texgen
