// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/event_context.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/events/event_subject.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

// An image of 400 x 200 pixels with 100 pixels to the unit shows 4 x 2 units around (5, 0).
TEST(EventContext, PositionsAreFractionsOfTheImage) {
    const View view{{5.0, 0.0}, 100.0};
    const Vec2 size(400.0, 200.0);
    EXPECT_NEAR((point_in_view(view, size, {0.5, 0.5}) - view.center).norm(), 0.0, 1e-15);
    EXPECT_NEAR((point_in_view(view, size, {0.0, 1.0}) - Vec2(3.0, 1.0)).norm(), 0.0, 1e-15);
}

TEST(EventContext, OnATorusPositionsAreFractionsOfIt) {
    test::EventSubject subject;
    const Domain& domain = subject.foam.domain;
    const Vec2 point = subject.context(2).point_at({0.25, 0.5});
    EXPECT_DOUBLE_EQ(point.x(), 0.25 * domain.width);
    EXPECT_DOUBLE_EQ(point.y(), 0.5 * domain.height);
}

TEST(EventContext, InAPatchPositionsAreFractionsOfTheView) {
    test::EventSubject subject;
    subject.foam = foam::test::circles({{0, {0.0, 0.0}, std::numbers::pi}});
    EventContext context = subject.context(2);
    context.view = {{1.0, 2.0}, 10.0};
    EXPECT_LT((context.point_at({1.0, 0.5}) - Vec2(6.0, 2.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace foam::texgen
