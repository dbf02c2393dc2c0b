// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulation.h"

#include "core/dynamics/restore_rafts.h"
#include "core/files/file_io.h"
#include "core/files/scratch_folder.h"
#include "texgen/animation/seed.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace foam::texgen {

namespace {

Preset small_preset() {
    Preset preset;
    preset.name = "small";
    preset.seeding.bubbles = 60;
    preset.image.width = 96;
    preset.image.height = 48;
    return preset;
}

// A shear loop strains the foam by amplitude * sin(2 pi t), as a part of the loop; its frames show
// the foam without this shear.
TEST(Simulation, AShearLoopStrainsTheFoamButNotItsFrames) {
    Preset preset = small_preset();
    preset.loop.kind = LoopKind::Shear;
    preset.loop.amplitude = 0.04;
    preset.frames.count = 8;
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const double start = simulation.strain();
    double largest = 0.0;
    for (int frame = 2; frame <= 9; ++frame) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_NEAR(simulation.strain() - start,
                    simulation.foam().domain.shear / simulation.foam().domain.height,
                    1e-12);
        EXPECT_NEAR(simulation.frame().domain.shear, 0.0, 1e-12);
        largest = std::max(largest, std::abs(simulation.strain() - start));
    }
    EXPECT_NEAR(largest, 0.04, 1e-12);
    EXPECT_NEAR(simulation.strain(), start, 1e-12);
}

// A patch loses gas to the atmosphere, so its area decreases.
TEST(Simulation, APatchStaysInEquilibriumWhileItLosesGas) {
    Preset preset = small_preset();
    preset.shape.kind = FoamKind::Patch;
    Simulation simulation(preset);
    double before = 1e9;
    for (int number = 1; number <= 20; ++number) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_LT(simulation.equilibrium().area_error, 1e-9);
        EXPECT_LT(simulation.equilibrium().angle_error, 1e-9);
        double area = 0.0;
        for (const FrameBubble& bubble : simulation.frame().bubbles) {
            area += bubble.area;
        }
        EXPECT_LT(area, before);
        before = area;
    }
}

// Writes an SVG of two L-shaped parts, 300 apart, and returns its path.
std::string two_parts(const ScratchFolder& folder) {
    const std::string path = (folder.path() / "parts.svg").string();
    const std::string_view svg =
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 100">)"
        R"(<path d="M0,0h30v70h70v30h-100z M300,0h100v30h-70v70h-30z"/></svg>)";
    write_file(path, std::as_bytes(std::span(svg)));
    return path;
}

// Returns the mean position of the bubbles on one side of x = 0.
Vec2 mean_of_side(const std::map<BubbleIdentity, Vec2>& centers,
                  const std::map<BubbleIdentity, Vec2>& seeded,
                  bool is_left) {
    Vec2 sum = Vec2::Zero();
    int count = 0;
    for (const auto& [identity, center] : centers) {
        if ((seeded.at(identity).x() < 0.0) == is_left) {
            sum += center;
            ++count;
        }
    }
    return sum / count;
}

// Equilibrium does not determine where the rafts of a patch are, nor their directions. Without
// restore_rafts, a raft turns by 0.20 radians with seed 1, and by 0.09 with seed 4. With it, the
// change of the shape turns the means that this test compares by up to 0.043 radians.
TEST(Simulation, RaftsOfAnOutlineOfSeveralPartsKeepTheirPlaces) {
    const ScratchFolder folder;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Preset preset = small_preset();
        assign(preset,
               std::vector{read_set_argument("foam.domain=patch"),
                           read_set_argument("foam.outline=" + two_parts(folder))});
        preset.seeding.bubbles = 200;
        preset.seeding.seed = seed;
        const std::map<BubbleIdentity, Vec2> seeded = bubble_centers(seeded_foam(preset));
        Simulation simulation(preset);
        ASSERT_TRUE(simulation.advance());
        std::map<BubbleIdentity, Vec2> shown;
        const Frame frame = simulation.frame();
        for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
            const BubbleId bubble = id_at<BubbleId>(k);
            Vec2 sum = Vec2::Zero();
            for (const HalfEdgeId h : frame.network.around(bubble)) {
                sum += frame.positions[frame.network.tail(h)];
            }
            shown[frame.bubbles[bubble].identity] = sum / frame.network.sides(bubble);
        }
        for (const bool is_left : {true, false}) {
            const Vec2 motion =
                mean_of_side(shown, seeded, is_left) - mean_of_side(seeded, seeded, is_left);
            EXPECT_LT(motion.norm(), 0.3) << "seed " << seed;
            double turn = 0.0;
            double weight = 0.0;
            for (const auto& [identity, center] : shown) {
                const Vec2 from = seeded.at(identity) - mean_of_side(seeded, seeded, is_left);
                const Vec2 to = center - mean_of_side(shown, seeded, is_left);
                if ((seeded.at(identity).x() < 0.0) == is_left) {
                    turn += cross(from, to);
                    weight += from.dot(to);
                }
            }
            EXPECT_NEAR(turn / weight, 0.0, 0.06) << "seed " << seed;
        }
    }
}

TEST(Simulation, CountsFramesFromOneAndTimeFromTheWarmUp) {
    Preset preset = small_preset();
    preset.frames.warm_up = 2.0;
    preset.frames.time_step = 0.5;
    Simulation simulation(preset);
    EXPECT_EQ(simulation.number(), 0);
    for (int number = 1; number <= 3; ++number) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_EQ(simulation.frame().number, number);
        EXPECT_NEAR(simulation.frame().time, 2.0 + 0.5 * (number - 1), 1e-12);
    }
}

// Bubbles that vanish in the step to a frame are replaced at the start of the next step. The
// bubbles of a frame and the T2s of the step to it therefore add up to 60.
TEST(Simulation, AFlowIsInASteadyState) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Flow, .growth = 8};
    preset.frames.time_step = 3.0;
    preset.frames.warm_up = 60.0;
    Simulation simulation(preset);
    int vanished = 0;
    for (int number = 1; number <= 60; ++number) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_LT(simulation.equilibrium().area_error, 1e-9);
        const int t2 = number > 1 ? simulation.equilibrium().t2 : 0;
        vanished += t2;
        const Frame frame = simulation.frame();
        if (number > 1) {
            EXPECT_EQ(frame.bubbles.size() + static_cast<std::size_t>(t2), 60U) << number;
        }
        // No bubble outgrows the others.
        for (const FrameBubble& bubble : frame.bubbles) {
            EXPECT_LT(bubble.area, 10.0 * frame.domain.area() / 60.0) << number;
        }
    }
    EXPECT_GT(vanished, 30);
    EXPECT_NEAR(simulation.frame().time, 60.0 + 59 * 3.0, 1e-9);
}

TEST(Simulation, ANewBubbleOfAFlowGrowsToTheMeanArea) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Flow, .growth = 4};
    preset.frames.time_step = 3.0;
    Simulation simulation(preset);
    const double mean = 1.0;  // area of the torus divided by its 60 bubbles
    std::map<BubbleIdentity, int> births;
    int grown = 0;
    for (int number = 1; number <= 30; ++number) {
        ASSERT_TRUE(simulation.advance());
        const Frame frame = simulation.frame();
        EXPECT_NEAR(frame.domain.area(), 60.0 * mean, 1e-9);
        for (const FrameBubble& bubble : frame.bubbles) {
            if (bubble.identity < 60) {
                continue;
            }
            const int age = number - births.emplace(bubble.identity, number).first->second;
            if (age < 4) {
                const double passed = (age + 1) / 4.0;
                EXPECT_GT(bubble.area, 0.9 * passed * mean) << number;
                EXPECT_LE(bubble.area, mean * (1.0 + 1e-9)) << number;
                grown += age == 3 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(grown, 5);
}

// The time steps are 1, 2 and 4, and there is no warm-up.
TEST(Simulation, StepsGrowByTheirFactor) {
    Preset preset = small_preset();
    preset.frames.step_growth = 2.0;
    Simulation simulation(preset);
    for (const double time : {0.0, 1.0, 3.0, 7.0}) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_NEAR(simulation.frame().time, time, 1e-12);
    }
}

// Frame 1 shows the diagram: films are straight and the angles are not 120 degrees. Frame 2 shows
// the foam that is frame 1 by default.
TEST(Simulation, BeginsWithTheDiagramWhereAsked) {
    Preset preset = small_preset();
    preset.frames.time_step = 0.0;
    Simulation usual(preset);
    ASSERT_TRUE(usual.advance());
    preset.frames.first = FirstFrame::Diagram;
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    for (const FilmArc& arc : simulation.frame().arcs) {
        EXPECT_EQ(arc.half_angle, 0.0);
    }
    EXPECT_GT(simulation.equilibrium().angle_error, 0.1);
    ASSERT_TRUE(simulation.advance());
    EXPECT_LT(simulation.equilibrium().angle_error, 1e-9);
    const Frame equilibrated = simulation.frame();
    const Frame expected = usual.frame();
    for (const JunctionId junction : expected.network.junctions()) {
        EXPECT_EQ(equilibrated.positions[junction], expected.positions[junction]);
    }
}

TEST(Simulation, EveryFrameIsInEquilibrium) {
    Simulation simulation(small_preset());
    for (int number = 1; number <= 20; ++number) {
        ASSERT_TRUE(simulation.advance());
        EXPECT_LT(simulation.equilibrium().area_error, 1e-9);
        EXPECT_LT(simulation.equilibrium().angle_error, 1e-9);
    }
}

// Every T2 removes one bubble; frame 1 counts the T2s of the warm-up. A frame after a time step of
// 0 counts no T1s and no T2s.
TEST(Simulation, CountsTheEventsOfEveryFrame) {
    Preset preset = small_preset();
    preset.frames.warm_up = 30.0;
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const int gone = 60 - static_cast<int>(simulation.frame().bubbles.size());
    EXPECT_GT(gone, 0);
    EXPECT_EQ(simulation.equilibrium().t2, gone);
    preset.frames.time_step = 0.0;
    Simulation still(preset);
    ASSERT_TRUE(still.advance());
    ASSERT_TRUE(still.advance());
    EXPECT_EQ(still.equilibrium().t1, 0);
    EXPECT_EQ(still.equilibrium().t2, 0);
    EXPECT_LT(still.equilibrium().area_error, 1e-9);
}

// The Gauss-Seidel solvers stop at the tolerance of the preset. Their errors are far larger than
// those of the default solver.
TEST(Simulation, TakesSolverAndToleranceFromThePreset) {
    Preset preset = small_preset();
    preset.equilibrium.tolerance = 1e-4;
    for (const Solver solver : {Solver::GaussSeidel, Solver::ColoredGaussSeidel}) {
        preset.equilibrium.solver = solver;
        Simulation simulation(preset);
        ASSERT_TRUE(simulation.advance());
        EXPECT_LT(simulation.equilibrium().angle_error, 1e-4);
        EXPECT_GT(simulation.equilibrium().angle_error, 1e-6);
    }
}

TEST(Simulation, DoesNotChangeWithoutTime) {
    Preset preset = small_preset();
    preset.frames.time_step = 0.0;
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const Frame first = simulation.frame();
    ASSERT_TRUE(simulation.advance());
    EXPECT_TRUE(simulation.frame().positions == first.positions);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns the largest displacement of a junction between two frames of one network.
double largest_motion(const Frame& from, const Frame& to) {
    double largest = 0.0;
    for (const JunctionId junction : from.network.junctions()) {
        const Vec2 motion = to.positions[junction] - from.positions[junction];
        largest = std::max(largest, from.domain.nearest_copy(motion).norm());
    }
    return largest;
}

// Returns frames 1 to count + 1 of a loop.
std::vector<Frame> frames_of_loop(const Preset& preset) {
    Simulation simulation(preset);
    std::vector<Frame> frames;
    for (int number = 1; number <= preset.frames.count + 1; ++number) {
        EXPECT_TRUE(simulation.advance()) << number;
        frames.push_back(simulation.frame());
    }
    EXPECT_LT(simulation.closing_error().value_or(0.0), 1e-9);
    return frames;
}

TEST(Simulation, ALoopEndsWhereItBegan) {
    for (const LoopKind kind : {LoopKind::Breathe, LoopKind::Shear}) {
        Preset preset = small_preset();
        preset.coarsening.kappa = 1.0;  // has no effect in these loops
        preset.frames.count = 12;
        preset.loop = {.kind = kind, .amplitude = 0.06};
        const std::vector<Frame> frames = frames_of_loop(preset);
        EXPECT_LT(largest_motion(frames.front(), frames.back()), 1e-9);
        EXPECT_GT(largest_motion(frames[0], frames[3]), 0.01);
        EXPECT_EQ(frames[3].domain.shear, 0.0);
    }
}

// Two of eight steps move every junction by a quarter of the drift. No junction moves relative to
// the others.
TEST(Simulation, DriftTravelsByWholePeriods) {
    Preset preset = small_preset();
    preset.frames.count = 8;
    preset.loop = {.kind = LoopKind::Drift, .drift = {-2, 1}};
    const std::vector<Frame> frames = frames_of_loop(preset);
    const Domain& domain = frames[0].domain;
    const Vec2 quarter(-0.5 * domain.width, 0.25 * domain.height);
    for (const JunctionId junction : frames[0].network.junctions()) {
        const Vec2 motion = frames[2].positions[junction] - frames[0].positions[junction];
        EXPECT_LT(domain.nearest_copy(motion - quarter).norm(), 1e-12);
    }
    EXPECT_EQ(largest_motion(frames.front(), frames.back()), 0.0);
}

// The frame one period after frame 1 shows the same ages. The record clamps ages to one period,
// which is 12; all bubbles are older than that.
TEST(Simulation, AgesOfALoopComeBackAfterAPeriod) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.45};
    preset.seeding.seed = 3;  // a foam whose films swap in every cycle
    preset.frames.count = 12;
    Simulation simulation(preset, 1);
    ASSERT_TRUE(simulation.advance());
    const double first_time = simulation.frame().time;
    const FoamRecord first = simulation.record();
    for (int k = 0; k < preset.frames.count; ++k) {
        ASSERT_TRUE(simulation.advance());
    }
    const double time = simulation.frame().time;
    const FoamRecord again = simulation.record();
    ASSERT_EQ(again.changes.size(), first.changes.size());
    for (std::size_t k = 0; k < first.changes.size(); ++k) {
        EXPECT_NEAR(time - again.changes[k], first_time - first.changes[k], 1e-9);
        EXPECT_NEAR(time - again.births[k], 12.0, 1e-9);
    }
    EXPECT_LT(first_time - *std::ranges::max_element(first.changes), 12.0);  // some changed
}

TEST(Simulation, APatchBreathes) {
    Preset preset = small_preset();
    preset.shape.kind = FoamKind::Patch;
    preset.seeding.bubbles = 20;
    preset.frames.count = 12;
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.1};
    const std::vector<Frame> frames = frames_of_loop(preset);
    EXPECT_LT(largest_motion(frames.front(), frames.back()), 1e-8);
}

// Returns the largest change of the area of a bubble, or infinity if the bubbles differ.
double largest_change_of_area(const Frame& from, const Frame& to) {
    std::map<BubbleIdentity, double> areas;
    for (const FrameBubble& bubble : from.bubbles) {
        areas[bubble.identity] = bubble.area;
    }
    double largest = areas.size() == to.bubbles.size() ? 0.0 : kInfinity;
    for (const FrameBubble& bubble : to.bubbles) {
        const auto found = areas.find(bubble.identity);
        if (found == areas.end()) {
            return kInfinity;
        }
        largest = std::max(largest, std::abs(bubble.area - found->second));
    }
    return largest;
}

// Every boiling bubble vanishes and is born once in the loop, with the same identity.
TEST(Simulation, ABoilEndsWhereItBegan) {
    Preset preset = small_preset();
    preset.frames.count = 12;
    preset.frames.smoothing = 4.0;
    preset.loop = {.kind = LoopKind::Boil, .amplitude = 0.1, .boiling = 0.1};
    Simulation simulation(preset, 1);
    ASSERT_TRUE(simulation.advance());
    EXPECT_LT(*simulation.closing_error(), 1e-9);
    const Frame first = simulation.frame();
    const FoamRecord record = simulation.record();
    std::set<std::size_t> counts;
    for (int k = 0; k < preset.frames.count; ++k) {
        ASSERT_TRUE(simulation.advance());
        counts.insert(simulation.frame().network.bubble_count());
    }
    EXPECT_GT(counts.size(), 1U);
    EXPECT_LT(*counts.begin(), static_cast<std::size_t>(preset.seeding.bubbles));
    EXPECT_LT(largest_change_of_area(first, simulation.frame()), 1e-9);
    const FoamRecord again = simulation.record();
    ASSERT_EQ(again.births.size(), static_cast<std::size_t>(preset.seeding.bubbles));
    for (const BubbleIdentity bubble : identities_of(first)) {
        EXPECT_NEAR(again.births[bubble] - record.births[bubble],
                    preset.frames.count * preset.frames.time_step,
                    1e-9);
        EXPECT_NEAR(
            again.averages.bubbles[bubble].area, record.averages.bubbles[bubble].area, 1e-9);
    }
}

// Returns the recorded events of the last `frames` frames: kind, number of frames since the event,
// x and y of its position.
std::vector<std::tuple<TopologyEventKind, int, double, double>> recent(const FoamRecord& record,
                                                                       int frames) {
    std::vector<std::tuple<TopologyEventKind, int, double, double>> events;
    for (const RecordedEvent& event : record.events) {
        const int frames_since = record.frame - event.frame;
        if (frames_since < frames) {
            events.emplace_back(event.kind, frames_since, event.position.x(), event.position.y());
        }
    }
    return events;
}

// The events of the cycle before frame 1 recur in the cycle after it. A T1 happens while the foam
// is equilibrated. Two cycles end in the same state, but the states in between differ slightly. The
// positions of events therefore agree only to 1e-4, which is far below a pixel.
TEST(Simulation, EventsOfALoopGoAround) {
    Preset preset = small_preset();
    preset.frames.count = 12;
    preset.seeding.seed = 3;  // a foam whose films swap in every cycle
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.45};
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.advance());
    const auto first = recent(simulation.record(), preset.frames.count);
    EXPECT_FALSE(first.empty());
    for (int k = 0; k < preset.frames.count; ++k) {
        ASSERT_TRUE(simulation.advance());
    }
    const auto again = recent(simulation.record(), preset.frames.count);
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        EXPECT_EQ(std::get<0>(again[k]), std::get<0>(first[k]));
        EXPECT_EQ(std::get<1>(again[k]), std::get<1>(first[k]));
        EXPECT_NEAR(std::get<2>(again[k]), std::get<2>(first[k]), 1e-4);
        EXPECT_NEAR(std::get<3>(again[k]), std::get<3>(first[k]), 1e-4);
    }
}

// Returns the progress that a simulation reports until it has reached frame 1.
std::vector<RunProgress> reports_before_first_frame(const Preset& preset) {
    std::vector<RunProgress> reports;
    Simulation simulation(
        preset, 1, [&](const RunProgress& progress) { reports.push_back(progress); });
    EXPECT_TRUE(simulation.advance());
    return reports;
}

TEST(Simulation, ReportsTheStepsOfTheWarmUp) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Flow, .growth = 6};
    preset.frames.count = 12;
    preset.frames.time_step = 2.0;
    preset.frames.warm_up = 9.0;  // five steps
    const std::vector<RunProgress> reports = reports_before_first_frame(preset);
    ASSERT_EQ(reports.size(), 1U + 5U);
    EXPECT_EQ(reports[0].phase, Phase::Equilibrium);
    for (std::size_t done = 0; done < 5; ++done) {
        const RunProgress& report = reports.at(1 + done);
        EXPECT_EQ(report.phase, Phase::WarmUp);
        EXPECT_EQ(report.done, static_cast<int>(done));
        EXPECT_EQ(report.total, 5);
        EXPECT_GT(report.bubbles, 50);
    }
}

TEST(Simulation, ReportsTheCyclesThatCloseALoop) {
    Preset preset = small_preset();
    preset.frames.count = 12;
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.06};
    const std::vector<RunProgress> reports = reports_before_first_frame(preset);
    ASSERT_GT(reports.size(), 13U);
    EXPECT_EQ(reports[0].phase, Phase::Equilibrium);
    EXPECT_EQ(reports[1].phase, Phase::LoopClosing);
    EXPECT_EQ(reports[1].measure, std::nullopt);
    const std::size_t cycles = (reports.size() - 1) / 13;
    EXPECT_EQ(reports.size(), 1 + 13 * cycles);  // before the first and after each of 12 steps
    EXPECT_EQ(reports.back().cycle, static_cast<int>(cycles));
    EXPECT_TRUE(reports.back().finished());
    EXPECT_LT(reports.back().measure.value_or(1.0), 1e-9);
    EXPECT_EQ(reports.back().usual_cycles, 0);
}

TEST(Simulation, ReportsHowManyCyclesABoilUsuallyNeeds) {
    Preset preset = small_preset();
    preset.frames.count = 24;
    preset.loop.kind = LoopKind::Boil;
    const std::vector<RunProgress> reports = reports_before_first_frame(preset);
    ASSERT_EQ(reports.back().phase, Phase::LoopClosing);
    EXPECT_EQ(reports.back().usual_cycles, 18);
}

TEST(Simulation, TheCallbackCanStopALoopThatIsBeingClosed) {
    Preset preset = small_preset();
    preset.frames.count = 12;
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.06};
    Simulation simulation(preset, 1, [](const RunProgress& progress) {
        if (progress.phase == Phase::LoopClosing && progress.done == 3) {
            throw std::runtime_error("stop");
        }
    });
    EXPECT_THROW(simulation.advance(), std::runtime_error);
}

}  // namespace

}  // namespace foam::texgen
