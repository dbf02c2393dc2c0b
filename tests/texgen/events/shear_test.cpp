// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/shear.h"

#include "tests/texgen/events/event_subject.h"
#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

EventBase shear_event() {
    EventBase event;
    event.kind = "shear";
    event.frames = {3, 6};
    return event;
}

// Each of four frames gets a quarter of the strain. The strains of two events add up.
TEST(Shear, SharesItsStrainAmongTheFrames) {
    test::EventSubject subject;
    EventContext context = subject.context(4);
    advance_shear(shear_event(), {.strain = 2.0}, context);
    EXPECT_DOUBLE_EQ(subject.change.strain, 0.5);
    advance_shear(shear_event(), {.strain = 1.0}, context);
    EXPECT_DOUBLE_EQ(subject.change.strain, 0.75);
}

TEST(Shear, IsForATorus) {
    const EventSetting patch{.is_patch = true, .t2_area = 0.01, .shorter_side = 4.0};
    EXPECT_EQ(test::checked(shear_event(), ShearOptions{}, check_shear), "accepted");
    EXPECT_EQ(test::checked(shear_event(), ShearOptions{}, check_shear, patch, "kind"),
              "kind: \"shear\" is only allowed with foam.domain = \"torus\"");
    EXPECT_EQ(test::checked(shear_event(), ShearOptions{}, check_shear, patch, "strain"),
              "foam: event[1].kind = \"shear\" is only allowed with foam.domain = \"torus\"");
}

TEST(Shear, LimitsHoldOnBothSides) {
    test::expect_limits(shear_keys(), {{"strain", "-101", "-100", "100", "101"}});
}

}  // namespace
}  // namespace foam::texgen
