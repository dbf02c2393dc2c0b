// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/frame_layers.h"

#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

namespace foam::texgen {
namespace {

TEST(FrameLayers, RequireTheNextFrame) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers with(subject.input(), test::torus_grid(16), 1);
    EXPECT_EQ(&with.next(), &subject.next);
    FrameLayers without({subject.frame, subject.record}, test::torus_grid(16), 1);
    EXPECT_THROW(without.next(), std::invalid_argument);
}

TEST(FrameLayers, SharedLayersAreMadeOnce) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers(subject.input(), test::torus_grid(16), 1);
    EXPECT_EQ(&layers.distance(), &layers.distance());
    EXPECT_EQ(&layers.arcs(2.0), &layers.arcs(2.0));
    EXPECT_NE(&layers.arcs(2.0), &layers.arcs(3.0));
    EXPECT_EQ(&layers.maze({}), &layers.maze({}));
    EXPECT_NE(&layers.maze({}), &layers.maze({.seed = 2}));
    EXPECT_EQ(&layers.wall_distances({}, {2.0}), &layers.wall_distances({}, {2.0}));
    EXPECT_NE(&layers.wall_distances({}, {2.0}), &layers.wall_distances({}, {2.0, true}));
    EXPECT_NE(&layers.wall_distances({}, {2.0}), &layers.wall_distances({.seed = 2}, {2.0}));
}

// The id after the ids of the bubbles stands for the surroundings of a patch.
TEST(FrameLayers, OnlyAPatchHasASurrounding) {
    const test::MapSubject& patch = test::patch_subject();
    FrameLayers of_patch(patch.input(), test::patch_grid(16), 1);
    const auto around = static_cast<std::uint32_t>(patch.frame.bubbles.size());
    EXPECT_TRUE(of_patch.is_patch());
    EXPECT_TRUE(of_patch.is_surroundings(around));
    EXPECT_FALSE(of_patch.is_surroundings(0));
    const test::MapSubject& torus = test::torus_subject();
    FrameLayers of_torus(torus.input(), test::torus_grid(16), 1);
    EXPECT_FALSE(of_torus.is_patch());
    EXPECT_FALSE(of_torus.is_surroundings(static_cast<std::uint32_t>(torus.frame.bubbles.size())));
}

}  // namespace
}  // namespace foam::texgen
