// SPDX-License-Identifier: Apache-2.0

#include "core/foam/spatial_order.h"

#include "core/foam/measure.h"
#include "core/foam/patch.h"
#include "core/foam/seeding.h"
#include "core/network/t2.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace foam {
namespace {

using test::is_valid;

// What a bubble is, apart from the numbers of its elements.
struct BubbleData {
    double pressure = 0.0;
    double target_area = 0.0;
    std::vector<std::pair<double, double>> corners;  // sorted
    std::vector<double> half_angles;                 // of its films; sorted
    std::vector<BubbleIdentity> neighbors;           // sorted

    friend bool operator==(const BubbleData& a, const BubbleData& b) = default;
};

std::map<BubbleIdentity, BubbleData> data_by_identity(const Foam& foam) {
    std::map<BubbleIdentity, BubbleData> all;
    for (const BubbleId bubble : foam.network.bubbles()) {
        BubbleData data{foam.pressures[bubble], foam.target_areas[bubble], {}, {}, {}};
        for (const HalfEdgeId h : foam.network.around(bubble)) {
            const Vec2& corner = foam.positions[foam.network.tail(h)];
            data.corners.emplace_back(corner.x(), corner.y());
            if (foam.domain.is_plane()) {
                data.half_angles.push_back(foam.half_angles[film_of(h)]);
            }
            data.neighbors.push_back(foam.identities[foam.network.right(h)]);
        }
        std::ranges::sort(data.corners);
        std::ranges::sort(data.half_angles);
        std::ranges::sort(data.neighbors);
        all[foam.identities[bubble]] = data;
    }
    return all;
}

// Returns the median difference between the numbers of the two bubbles beside a film.
long median_distance_in_memory(const Foam& foam) {
    std::vector<long> distances;
    for (const FilmId film : foam.network.films()) {
        const auto left = static_cast<long>(index_of(foam.network.left(forward_side(film))));
        const auto right = static_cast<long>(index_of(foam.network.right(forward_side(film))));
        distances.push_back(std::abs(left - right));
    }
    std::ranges::nth_element(distances, distances.begin() + std::ssize(distances) / 2);
    return distances[distances.size() / 2];
}

TEST(SpatialOrder, NeighborsAreCloseInMemory) {
    Foam foam = seed_foam({.bubbles = 4096, .lloyd_iterations = 2, .seed = 3});
    EXPECT_GT(median_distance_in_memory(foam), 800);
    sort_along_curve(foam);
    EXPECT_LT(median_distance_in_memory(foam), 30);
}

TEST(SpatialOrder, ChangesNothingButNumbers) {
    Foam torus = seed_foam({.bubbles = 300, .area_ratio = 20.0, .seed = 5});
    const auto before = data_by_identity(torus);
    sort_along_curve(torus);
    EXPECT_TRUE(is_valid(torus.network));
    EXPECT_EQ(data_by_identity(torus), before);
}

TEST(SpatialOrder, TheGhostOfAPatchRemainsTheLastBubble) {
    Foam patch = seed_patch(disc_outline(), {.bubbles = 300, .seed = 5});
    const auto before = data_by_identity(patch);
    const double energy_before = energy(patch);
    sort_along_curve(patch);
    EXPECT_TRUE(is_valid(patch.network));
    EXPECT_TRUE(patch.network.is_compact());
    EXPECT_EQ(index_of(patch.network.ghost()), patch.network.bubble_count());
    EXPECT_EQ(data_by_identity(patch), before);
    EXPECT_NEAR(energy(patch), energy_before, 1e-12 * energy_before);
}

TEST(SpatialOrder, OnlyLargeFoamsAreSorted) {
    const int limit = static_cast<int>(kMinSortedBubbles);
    EXPECT_GT(median_distance_in_memory(seed_foam({.bubbles = limit - 1, .seed = 2})), 4000);
    EXPECT_LT(median_distance_in_memory(seed_foam({.bubbles = limit, .seed = 2})), 30);
    const Foam patch = seed_patch(disc_outline(), {.bubbles = limit + limit / 10, .seed = 2});
    EXPECT_GE(patch.network.bubble_count(), kMinSortedBubbles);
    EXPECT_LT(median_distance_in_memory(patch), 30);
}

TEST(SpatialOrder, DeadSlotsAreRemoved) {
    Foam foam = test::honeycomb_around(3);
    vanish(foam.network, BubbleId{5});
    sort_along_curve(foam);
    EXPECT_TRUE(foam.network.is_compact());
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_EQ(foam.positions.size(), foam.network.junction_slots());
    EXPECT_EQ(foam.identities.size(), foam.network.bubble_slots());
}

}  // namespace
}  // namespace foam
