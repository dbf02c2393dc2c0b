// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/displaced_frame.h"

#include "core/foam/corners.h"
#include "core/network/validate.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <optional>

namespace foam::texgen {
namespace {

const Foam& sample_foam() {
    static const Foam foam = foam::test::polydisperse_foam(40, 2);
    return foam;
}

// Turns the foam by 90 degrees about a point: arcs stay arcs with the same half angles.
TEST(DisplacedFrame, ATurnKeepsArcs) {
    const Frame frame = snapshot(sample_foam(), 1);
    const auto by = [](const Vec2& point) { return Vec2(Vec2(-point.y(), point.x()) - point); };
    Indexed<JunctionId, Vec2> of_junctions;
    for (const Vec2& position : frame.positions) {
        of_junctions.push_back(by(position));
    }
    Indexed<FilmId, Vec2> of_middles;
    FilmId inner = kNone<FilmId>;  // a film that does not cross the border of the torus
    for (const FilmId film : frame.network.films()) {
        const Vec2& tail = frame.positions[frame.network.tail(forward_side(film))];
        of_middles.push_back(by(tail + point_at(frame.arcs[film], 0.5)));
        inner = frame.network.offset(forward_side(film)) == LatticeOffset{} ? film : inner;
    }
    ASSERT_NE(inner, kNone<FilmId>);
    const Frame turned = displaced(frame, of_junctions, of_middles);
    EXPECT_EQ(find_fault(turned.network), std::nullopt);
    const Vec2& chord = frame.arcs[inner].chord;
    EXPECT_LT((turned.arcs[inner].chord - Vec2(-chord.y(), chord.x())).norm(), 1e-12);
    EXPECT_NEAR(turned.arcs[inner].half_angle, frame.arcs[inner].half_angle, 1e-12);
}

// A straight film whose middle is moved by half its length to the right becomes a half circle.
TEST(DisplacedFrame, FilmsGoThroughTheirMiddles) {
    const Frame frame = snapshot(sample_foam(), 1);
    const FilmId film = id_at<FilmId>(0);
    const FilmArc& arc = frame.arcs[film];
    Indexed<FilmId, Vec2> of_middles(frame.arcs.size(), Vec2::Zero());
    const Vec2 to_the_right = 0.5 * Vec2(arc.chord.y(), -arc.chord.x());
    of_middles[film] = 0.5 * arc.chord + to_the_right - point_at(arc, 0.5);
    const Indexed<JunctionId, Vec2> of_junctions(frame.positions.size(), Vec2::Zero());
    const FilmArc bent = displaced(frame, of_junctions, of_middles).arcs[film];
    EXPECT_NEAR(bent.half_angle, 0.5 * 3.14159265358979, 1e-12);
    EXPECT_EQ(bent.chord, arc.chord);
}

TEST(DisplacedFrame, TheMeanCornerIsThatOfTheFoam) {
    const Frame frame = snapshot(sample_foam(), 1);
    for (const BubbleId bubble : frame.network.bubbles()) {
        const Vec2 off = mean_corner(frame, bubble) - foam::mean_corner(sample_foam(), bubble);
        EXPECT_LT(frame.domain.nearest_copy(off).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace foam::texgen
