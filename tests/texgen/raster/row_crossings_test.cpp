#include "texgen/raster/row_crossings.h"

#include "tests/support/raster_masks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 40;

CellMask mask_of(const std::vector<SnappedArc>& arcs, int unused_rows = 0) {
    return test::mask_of(arcs, kSide, kSide, unused_rows);
}

bool holds(const CellMask& mask, int x, int y) {
    return ((mask.whole_row(y) >> x) & 1) != 0;
}

SnappedArc arc_between(SubpixelPoint tail, SubpixelPoint head, double half_angle) {
    return {tail, head, std::cos(half_angle), std::sin(half_angle)};
}

constexpr double kRadius = 15.3;
constexpr double kCenterX = 20.0;
constexpr double kCenterY = 19.0;

SubpixelPoint on_circle(double angle) {
    return to_subpixel(
        Vec2(kCenterX + kRadius * std::cos(angle), kCenterY + kRadius * std::sin(angle)));
}

void expect_circle(const CellMask& mask) {
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double distance = std::hypot(x + 0.5 - kCenterX, y + 0.5 - kCenterY);
            if (std::abs(distance - kRadius) > 2.0 / kSubpixel) {
                ASSERT_EQ(holds(mask, x, y), distance < kRadius) << x << ", " << y;
            }
        }
    }
}

// Two arcs cut by a chord at any angle, of less and of more than half a turn: they rise, fall and
// do both.
TEST(RowCrossings, GoAroundThePixelsOfACircle) {
    for (const double half_angle : {0.3, 0.9, 1.5, 1.9, 2.8}) {
        for (int turn = 0; turn < 24; ++turn) {
            const double middle = 2.0 * std::numbers::pi * turn / 24.0;
            const SubpixelPoint from = on_circle(middle - half_angle);
            const SubpixelPoint to = on_circle(middle + half_angle);
            expect_circle(mask_of({arc_between(from, to, half_angle),
                                   arc_between(to, from, std::numbers::pi - half_angle)}));
        }
    }
}

// A film bent to and fro beside a straight one: what one of its sides has, the other has not.
TEST(RowCrossings, AreTheSameFromBothSides) {
    const SubpixelPoint a{5200, 3100};
    const SubpixelPoint b{30500, 33333};
    const SubpixelPoint left{1000, 35000};
    const SubpixelPoint right{39000, 2000};
    for (const double half_angle : {-1.2, -0.4, 0.0, 0.7, 1.3}) {
        const SnappedArc shared = arc_between(a, b, half_angle);
        const CellMask one = mask_of({shared, arc_between(b, left, 0), arc_between(left, a, 0)});
        const CellMask two = mask_of({shared, arc_between(a, right, 0), arc_between(right, b, 0)});
        const CellMask both = mask_of({arc_between(b, left, 0),
                                       arc_between(left, a, 0),
                                       arc_between(a, right, 0),
                                       arc_between(right, b, 0)});
        for (int y = 0; y < kSide; ++y) {
            EXPECT_EQ(one.whole_row(y) ^ two.whole_row(y), both.whole_row(y));
        }
    }
}

TEST(RowCrossings, LeaveOutRowsThatAreNotUsed) {
    const std::vector<SnappedArc> square{arc_between({1024, 1024}, {9000, 1024}, 0.0),
                                         arc_between({9000, 1024}, {9000, 30000}, 0.0),
                                         arc_between({9000, 30000}, {1024, 30000}, 0.0),
                                         arc_between({1024, 30000}, {1024, 1024}, 0.0)};
    const CellMask whole = mask_of(square);
    const CellMask part = mask_of(square, 7);
    for (int y = 0; y < kSide; ++y) {
        EXPECT_EQ(part.whole_row(y), y < 7 ? 0 : whole.whole_row(y));
    }
    EXPECT_NE(whole.whole_row(6), 0);
}

}  // namespace
}  // namespace foam::texgen
