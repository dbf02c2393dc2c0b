// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/current.h"

#include "core/foam/foam.h"
#include "core/network/validate.h"
#include "tests/support/sample_foams.h"
#include "texgen/animation/simulate_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

constexpr double kStrength = 0.3;
constexpr double kSide = 10.0;

Current current_of(double strength, int eddies = 1) {
    return {LoopOptions{.current = strength, .eddies = eddies}, 1.0, 5};
}

const Frame& still_frame() {
    static const Frame frame = snapshot(foam::test::polydisperse_foam(100, 4), 1);
    return frame;
}

// Returns the largest error of the ends of films: the position of the head minus the position of
// the tail should be the chord.
double largest_gap(const Frame& frame) {
    double largest = 0.0;
    for (const FilmId film : frame.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const Vec2 chord = frame.positions[frame.network.head(h)] +
                           frame.domain.translation(frame.network.offset(h)) -
                           frame.positions[frame.network.tail(h)];
        largest = std::max(largest, (chord - frame.arcs[film].chord).norm());
    }
    return largest;
}

double area_of(const Frame& frame, BubbleId bubble) {
    double area = 0.0;
    Vec2 at = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const FilmArc arc = frame.arc(h);
        area += 0.5 * cross(at, arc.chord) + segment_area(arc);
        at += arc.chord;
    }
    return area;
}

TEST(Current, IsPeriodicInSpaceAndTime) {
    const Current current = current_of(kStrength);
    const Domain domain{kSide, kSide};
    const Vec2 point(1.3, 8.1);
    const Vec2 by = current.displacement(point, domain, 0.3);
    EXPECT_LT((current.displacement(point, domain, 1.3) - by).norm(), 1e-12);
    EXPECT_LT((current.displacement(point + Vec2(kSide, -2.0 * kSide), domain, 0.3) - by).norm(),
              1e-12);
    EXPECT_GT((current.displacement(point, domain, 0.5) - by).norm(), 0.05);
}

// On a sheared torus the periods are (width, 0) and (shear, height).
TEST(Current, HasNoSeamOnAShearedTorus) {
    const Current current = current_of(kStrength);
    const Domain domain{kSide, kSide, 3.7};
    const Vec2 point(1.3, 8.1);
    const Vec2 by = current.displacement(point, domain, 0.3);
    EXPECT_LT((current.displacement(point + Vec2(3.7, kSide), domain, 0.3) - by).norm(), 1e-12);
}

// The determinant of the derivative is the factor by which the current changes areas. The root mean
// square of the derivative is near the strength.
TEST(Current, PreservesAreasAndHasItsStrength) {
    const Current current = current_of(kStrength, 2);
    const Domain domain{kSide, kSide};
    constexpr double kStep = 1e-4;
    double squares = 0.0;
    int count = 0;
    for (double x = 0.3; x < kSide; x += 0.7) {
        for (double y = 0.2; y < kSide; y += 0.7) {
            const auto at = [&](double dx, double dy) {
                const Vec2 point(x + dx, y + dy);
                return Vec2(point + current.displacement(point, domain, 0.4));
            };
            const Vec2 across = (at(kStep, 0.0) - at(-kStep, 0.0)) / (2.0 * kStep);
            const Vec2 up = (at(0.0, kStep) - at(0.0, -kStep)) / (2.0 * kStep);
            EXPECT_NEAR(cross(across, up), 1.0, 1e-5);
            squares +=
                (across - Vec2(1.0, 0.0)).squaredNorm() + (up - Vec2(0.0, 1.0)).squaredNorm();
            ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), kStrength, 0.4 * kStrength);
}

TEST(Current, CarriedFramesAreSound) {
    for (const double strength : {0.1, 0.3, 0.6}) {
        for (const double progress : {0.0, 0.25, 0.7}) {
            const Frame frame = current_of(strength).carried(still_frame(), progress);
            EXPECT_EQ(find_fault(frame.network), std::nullopt);
            EXPECT_LT(largest_gap(frame), 1e-12);
            for (const BubbleId bubble : frame.network.bubbles()) {
                const double area = frame.bubbles[bubble].area;
                EXPECT_NEAR(area_of(frame, bubble), area, 0.03 * area) << strength;
            }
        }
    }
}

TEST(Current, WithoutStrengthNothingMoves) {
    const Frame frame = current_of(0.0).carried(still_frame(), 0.4);
    EXPECT_EQ(frame.positions, still_frame().positions);
    for (const FilmId film : frame.network.films()) {
        EXPECT_EQ(frame.arcs[film].chord, still_frame().arcs[film].chord);
        EXPECT_NEAR(frame.arcs[film].half_angle, still_frame().arcs[film].half_angle, 1e-12);
    }
}

// The foam of a drift does not change, so that all motion but the drift comes from the current. The
// frame after the last one is frame 1.
TEST(Current, MovesTheFramesOfALoopAndClosesIt) {
    Preset preset;
    preset.seeding.bubbles = 60;
    preset.frames.count = 6;
    preset.loop = {.kind = LoopKind::Drift, .drift = {1, 0}, .current = kStrength};
    std::vector<std::shared_ptr<const Frame>> frames;
    std::shared_ptr<const Frame> after_last;
    simulate_frames(
        preset, 1, {1, 2, 3, 4, 5, 6}, NextFrames::Included, [&](const SimulatedFrame& shown) {
            frames.push_back(shown.frame);
            after_last = shown.next;
        });
    ASSERT_EQ(frames.size(), 6U);
    EXPECT_EQ(after_last->positions, frames.front()->positions);
    const Domain& domain = frames[0]->domain;
    const Vec2 drift(domain.width / 6.0, 0.0);
    double largest = 0.0;
    for (const JunctionId junction : frames[0]->network.junctions()) {
        const Vec2 moved = frames[1]->positions[junction] - frames[0]->positions[junction] - drift;
        largest = std::max(largest, domain.nearest_copy(moved).norm());
    }
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(largest, 2.0);
}

}  // namespace
}  // namespace foam::texgen
