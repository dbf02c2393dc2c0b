#include "texgen/animation/new_bubble.h"

#include "core/dynamics/nucleation.h"
#include "core/foam/locate.h"

#include <limits>

namespace foam::texgen {

namespace {

constexpr int kMostTries = 100;

// A place on the torus, or in the box around the patch.
Vec2 random_place(const Foam& foam, Random& random) {
    const double x = random.uniform();
    const double y = random.uniform();
    if (!foam.domain.is_plane()) {
        return {x * foam.domain.width, y * foam.domain.height};
    }
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const JunctionId junction : foam.network.junctions()) {
        low = low.cwiseMin(foam.positions[junction]);
        high = high.cwiseMax(foam.positions[junction]);
    }
    return low + Vec2(x, y).cwiseProduct(high - low);
}

}  // namespace

std::optional<BubbleId> nucleate_near(NucleationSite on,
                                      const Vec2& place,
                                      double area,
                                      Foam& foam) {
    if (!bubble_at(foam, place)) {
        return std::nullopt;
    }
    if (on == NucleationSite::Junction) {
        return nucleate_at_junction(foam, nearest_junction(foam, place), area);
    }
    return nucleate_on_film(foam, nearest_film(foam, place), area);
}

std::optional<BubbleId> nucleate_anywhere(NucleationSite on,
                                          double area,
                                          Random& random,
                                          Foam& foam) {
    for (int k = 0; k < kMostTries; ++k) {
        const Vec2 place = random_place(foam, random);
        if (const auto bubble = nucleate_near(on, place, area, foam)) {
            return bubble;
        }
    }
    return std::nullopt;
}

}  // namespace foam::texgen
