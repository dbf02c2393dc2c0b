// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/timeline.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/locate.h"
#include "core/foam/seeding.h"
#include "core/foam/statistics.h"
#include "texgen/animation/seed.h"
#include "texgen/animation/simulation.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace foam::texgen {
namespace {

Preset preset_with(const std::string& events) {
    return parse_preset(
        "[foam]\nbubbles = 66\nseed = 3\n[dynamics]\nkappa = 0\n[image]\nsize = [96, 96]\n" +
            events,
        "t",
        "t.toml");
}

Foam foam_of(const Preset& preset) {
    Foam foam = seed_foam(preset.seeding);
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

// Two events: one with frames, one with a time that overlaps the steps to the frames 3 and 4.
TEST(Timeline, TheStrainOfEventsIsThatOfTheSimulation) {
    const Preset preset = preset_with(
        "[frames]\ncount = 6\n[[event]]\nkind = \"shear\"\nframes = [2, 5]\n"
        "strain = 0.3\n[[event]]\nkind = \"shear\"\ntime = [1.1, 2.9]\nstrain = -0.2\n");
    Simulation simulation(preset, 1);
    for (int state = 1; state <= 6; ++state) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_NEAR(strain_of_events(preset, state), simulation.strain(), 1e-12) << state;
    }
    EXPECT_NEAR(strain_of_events(preset, 6), 0.1, 1e-12);
}

TEST(Timeline, WithoutEventsChangesNothing) {
    const Preset preset = preset_with("");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    for (int frame = 2; frame < 10; ++frame) {
        EXPECT_TRUE(timeline.changes_to(frame, foam).empty());
    }
}

// Over frames 3 to 6 the target area falls from its initial value to the T2 area, 0.01, in four
// equal steps.
TEST(Timeline, ACollapseIsARampToTheT2Area) {
    const Preset preset =
        preset_with("[[event]]\nkind = \"collapse\"\nframes = [3, 6]\nbubble = 20\n");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    const double area = foam.target_areas[BubbleId{20}];
    EXPECT_TRUE(timeline.changes_to(2, foam).empty());
    for (int k = 1; k <= 4; ++k) {
        const StateChange change = timeline.changes_to(2 + k, foam);
        ASSERT_EQ(change.driven.size(), 1U);
        EXPECT_EQ(change.driven[0].bubble, 20U);
        EXPECT_NEAR(change.driven[0].target_area, area - 0.25 * k * (area - 0.01), 1e-14);
        EXPECT_EQ(change.driven[0].vanishes, k == 4);
    }
    EXPECT_TRUE(timeline.changes_to(7, foam).empty());
}

TEST(Timeline, BubblesAreChosenByPositionOrSides) {
    const Preset preset = preset_with(
        "[[event]]\nkind = \"drive\"\nframe = 2\nat = [0.25, 0.75]\n"
        "[[event]]\nkind = \"drive\"\nframe = 3\nsides = [4, 6]\ncount = 3\n"
        "[[event]]\nkind = \"drive\"\nframe = 4\n");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    const Vec2 position(0.25 * foam.domain.width, 0.75 * foam.domain.height);
    StateChange change = timeline.changes_to(2, foam);
    ASSERT_EQ(change.driven.size(), 1U);
    EXPECT_EQ(change.driven[0].bubble, identity_at(foam, position));
    std::set<BubbleIdentity> expected;  // the two smallest of 4 sides, the smallest of 6
    for (const std::size_t rank : {0U, 1U}) {
        expected.insert(foam.identities[bubbles_of_sides(foam, 4)[rank]]);
    }
    expected.insert(foam.identities[bubbles_of_sides(foam, 6)[0]]);
    std::set<BubbleIdentity> chosen;
    for (const DrivenBubble& driven : timeline.changes_to(3, foam).driven) {
        chosen.insert(driven.bubble);
    }
    EXPECT_EQ(chosen, expected);
    EXPECT_EQ(timeline.changes_to(4, foam).driven.size(), 66U);
}

// The area oscillates by 20 % with a period of 8 frames.
TEST(Timeline, ADriveSwingsWithItsPeriodInFrames) {
    const Preset preset = preset_with(
        "[[event]]\nkind = \"drive\"\nframes = [2, 17]\nbubble = 5\namplitude = 0.2\nperiod = 8\n");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    const double area = foam.target_areas[BubbleId{5}];
    for (int k = 1; k <= 16; ++k) {
        const double swing = 1.0 + 0.2 * std::sin(2.0 * std::numbers::pi * k / 8.0);
        EXPECT_NEAR(timeline.changes_to(1 + k, foam).driven[0].target_area, swing * area, 1e-14);
    }
}

TEST(Timeline, TheLastEventOverridesEarlierOnes) {
    const Preset preset = preset_with(
        "[[event]]\nkind = \"drive\"\nframes = [2, 9]\nbubble = [4, 5]\nscale = 2\n"
        "[[event]]\nkind = \"collapse\"\nframes = [4, 4]\nbubble = 5\n");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    timeline.changes_to(2, foam);
    timeline.changes_to(3, foam);
    const StateChange change = timeline.changes_to(4, foam);
    ASSERT_EQ(change.driven.size(), 2U);
    EXPECT_EQ(change.driven[1].bubble, 5U);
    EXPECT_TRUE(change.driven[1].vanishes);
    EXPECT_EQ(timeline.changes_to(5, foam).driven.size(), 1U);
}

// Four bubbles begin evenly over eight frames, in the steps to frames 2, 4, 6 and 8. Each grows to
// its area in three frames.
TEST(Timeline, NewBubblesBeginEvenlyOverTheFrames) {
    const Preset preset = preset_with(
        "[[event]]\nkind = \"nucleate\"\nframes = [2, 9]\ncount = 4\narea = 0.5\ngrowth = 3\n");
    Timeline timeline(preset);
    Foam foam = foam_of(preset);
    const std::vector<std::size_t> bubbles{67, 67, 68, 68, 69, 69, 70, 70};
    const std::vector<std::size_t> growing{1, 1, 2, 1, 2, 1, 2, 1, 1};
    for (int frame = 2; frame <= 10; ++frame) {
        const auto k = static_cast<std::size_t>(frame - 2);
        const StateChange change = timeline.changes_to(frame, foam);
        EXPECT_EQ(change.driven.size(), growing[k]) << frame;
        EXPECT_EQ(foam.network.bubble_count(), k < 8 ? bubbles[k] : 70U) << frame;
    }
}

// Returns the identities of the bubbles that have vanished at frame `frames`.
std::vector<BubbleIdentity> collapsed_identities(const std::string& events, int frames) {
    Simulation simulation(preset_with(events));
    std::vector<BubbleIdentity> alive;
    for (int number = 1; number <= frames; ++number) {
        EXPECT_TRUE(simulation.advance()) << number;
        EXPECT_LT(simulation.equilibrium().area_error, 1e-9) << number;
        EXPECT_LT(simulation.equilibrium().angle_error, 1e-9) << number;
    }
    for (const FrameBubble& bubble : simulation.frame().bubbles) {
        alive.push_back(bubble.identity);
    }
    std::vector<BubbleIdentity> gone;
    for (BubbleIdentity identity = 0; identity < 66; ++identity) {
        if (std::find(alive.begin(), alive.end(), identity) == alive.end()) {
            gone.push_back(identity);
        }
    }
    return gone;
}

TEST(TimelineInSimulation, CollapsesAtItsFrame) {
    const std::string event = "[[event]]\nkind = \"collapse\"\nframes = [3, 5]\nbubble = [9, 30]\n";
    EXPECT_EQ(collapsed_identities(event, 2), std::vector<BubbleIdentity>{});
    EXPECT_EQ(collapsed_identities(event, 5), (std::vector<BubbleIdentity>{9, 30}));
}

TEST(TimelineInSimulation, CollapsesInTurn) {
    const std::string event =
        "[[event]]\nkind = \"collapse\"\nframes = [2, 21]\nsides = [4, 5, 6]\ncount = 10\n"
        "order = \"in-turn\"\n";
    EXPECT_EQ(collapsed_identities(event, 11).size(), 5U);
    EXPECT_EQ(collapsed_identities(event, 21).size(), 10U);
}

// Without new bubbles 28 of 66 bubbles are left. With 40 new bubbles, which are larger than the
// mean, 59 are left.
TEST(TimelineInSimulation, NewBubblesKeepAFoamAlive) {
    Preset preset = preset_with(
        "[[event]]\nkind = \"nucleate\"\nframes = [2, 61]\ncount = 40\narea = 2\ngrowth = 10\n");
    preset.coarsening.kappa = 0.03;
    Preset without = preset;
    without.events.clear();
    std::vector<std::size_t> left;
    for (const Preset& each : {preset, without}) {
        Simulation simulation(each);
        for (int number = 1; number <= 61; ++number) {
            ASSERT_TRUE(simulation.advance()) << number;
            ASSERT_LT(simulation.equilibrium().area_error, 1e-9);
        }
        left.push_back(simulation.frame().bubbles.size());
    }
    EXPECT_LT(left[1], 35U);
    EXPECT_GT(left[0], left[1] + 20);
}

// Returns a preset of a patch of 66 bubbles, shown with a margin of 25 % on each side. The middle
// of the image shows foam; its corners show none.
Preset patch_preset_with(const std::string& events) {
    return parse_preset(
        "[foam]\ndomain = \"patch\"\nbubbles = 66\nseed = 3\n[dynamics]\nkappa = 0\n"
        "[camera]\nmargin = 0.25\n" +
            events,
        "t",
        "t.toml");
}

// Returns the number of bubbles at frame `frames`, lone bubbles included.
std::size_t bubbles_after(const Preset& preset, int frames) {
    Simulation simulation(preset);
    for (int number = 1; number <= frames; ++number) {
        EXPECT_TRUE(simulation.advance()) << number;
        EXPECT_LT(simulation.equilibrium().area_error, 1e-9) << number;
    }
    return simulation.frame().bubbles.size() + simulation.frame().lone_bubbles.size();
}

TEST(TimelineInPatch, PositionsAreFractionsOfTheView) {
    const std::string collapse = "[[event]]\nkind = \"collapse\"\nframe = 3\nat = ";
    const std::size_t all = bubbles_after(patch_preset_with(""), 1);
    EXPECT_EQ(bubbles_after(patch_preset_with(collapse + "[0.5, 0.5]\n"), 3), all - 1);
    EXPECT_EQ(bubbles_after(patch_preset_with(collapse + "[0.05, 0.95]\n"), 3), all);
    Preset close = patch_preset_with(collapse + "[0.05, 0.95]\n");
    close.camera.zoom = 4.0;  // the corner shows the patch now
    EXPECT_EQ(bubbles_after(close, 3), all - 1);
}

TEST(TimelineInPatch, DrivesTheBubbleSeenAtThePosition) {
    const Preset preset =
        patch_preset_with("[[event]]\nkind = \"drive\"\nframe = 2\nat = [0.4, 0.6]\n");
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const View view = *simulation.view();
    Timeline timeline(preset);
    timeline.set_view(view);
    Foam foam = seeded_foam(preset);
    ASSERT_TRUE(equilibrate(foam, {}).converged());
    // The position is a tenth of the image, 102.4 of its 1024 pixels, left of the center and as far
    // above it.
    const Vec2 position = view.center + Vec2(-102.4, 102.4) / view.pixels_per_unit;
    const StateChange change = timeline.changes_to(2, foam);
    ASSERT_EQ(change.driven.size(), 1U);
    EXPECT_EQ(change.driven[0].bubble, identity_at(foam, position));
}

TEST(TimelineInPatch, NewBubblesBeginWithinIt) {
    const std::string nucleate = "[[event]]\nkind = \"nucleate\"\nframes = [2, 5]\n";
    const std::size_t all = bubbles_after(patch_preset_with(""), 1);
    EXPECT_EQ(bubbles_after(patch_preset_with(nucleate + "count = 8\n"), 5), all + 8);
    EXPECT_EQ(bubbles_after(patch_preset_with(nucleate + "at = [0.05, 0.95]\n"), 5), all);
}

TEST(TimelineInPatch, AllBubblesMayBeDriven) {
    const Preset preset = patch_preset_with(
        "[[event]]\nkind = \"drive\"\nframes = [2, 7]\nscale = 1.5\namplitude = 0.3\n"
        "period = 6\nphases = \"random\"\n");
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const double before = mean_area(simulation.frame());
    for (int number = 2; number <= 7; ++number) {
        ASSERT_TRUE(simulation.advance()) << number;
    }
    EXPECT_GT(mean_area(simulation.frame()), 1.3 * before);
}

TEST(TimelineInSimulation, TheSeedDecidesWhereBubblesBegin) {
    const std::string events = "[[event]]\nkind = \"nucleate\"\nframe = 2\ncount = 3\n";
    const auto positions = [&](int seed) {
        Preset preset = preset_with(events);
        preset.seeding.seed = static_cast<std::uint64_t>(seed);
        Simulation simulation(preset);
        EXPECT_TRUE(simulation.advance());
        EXPECT_TRUE(simulation.advance());
        EXPECT_EQ(simulation.frame().bubbles.size(), 69U);
        return simulation.frame().positions;
    };
    EXPECT_TRUE(positions(3) == positions(3));
    EXPECT_FALSE(positions(3) == positions(4));
}

}  // namespace
}  // namespace foam::texgen
