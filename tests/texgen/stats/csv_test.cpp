// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/csv.h"

#include "core/foam/honeycomb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// T = 1 and kappa = 1/2, so von Neumann's law is dA/dt = (pi/6) (n - 6).
RunRecord synthetic_run() {
    RunRecord run{"made_up", 1.0, 0.5, std::vector<FrameRecord>(2)};
    FrameRecord& first = run.frames[0];
    first.frame = 1;
    first.foam = {4, 1.0, 7.25, 6.0, 0.5, {}};
    first.foam.by_sides = {{5, 1, 0.5, 0.25, -1.0}, {6, 3, 1.125, -0.0625, 0.0}};
    first.effort = {12, 0, 1e-12, 0.1 + 0.2, 1.5};
    FrameRecord& second = run.frames[1];
    second.frame = 3;
    second.time = 2.5;
    second.foam = {2, 2.0, 6.5, 6.0, 0.0, {}};
    second.foam.by_sides = {{6, 2, 2.0, 0.0, 0.0}};
    second.growth = {{6, 1, 1e-10}};
    second.effort = {3, 2, 0.0, 2e-16, 0.125};
    return run;
}

// Replaces the global locale by one that writes 1234.5 as 1.2.3.4,5. The destructor restores it.
class CommaLocale {
  public:
    CommaLocale() : before_(std::locale::global(std::locale(std::locale(), new Commas))) {}
    ~CommaLocale() { std::locale::global(before_); }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

  private:
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\1"; }
    };
    std::locale before_;
};

constexpr const char* kFrames =
    "frame,time,bubbles,mean_area,energy,second_moment,area_error,angle_error,t1,t2,seconds\n"
    "1,0,4,1,7.25,0.5,1e-12,0.30000000000000004,12,0,1.5\n"
    "3,2.5,2,2,6.5,0,0,2e-16,3,2,0.125\n";

TEST(Csv, FramesGolden) {
    EXPECT_EQ(frames_csv(synthetic_run()), kFrames);
}

TEST(Csv, SidesGolden) {
    EXPECT_EQ(sides_csv(synthetic_run()),
              "frame,time,sides,bubbles,share,mean_area,mean_pressure,"
              "untouched,area_rate,film_rate,law_rate\n"
              "1,0,5,1,0.25,0.5,0.25,0,,-0.5,-0.5235987755982988\n"
              "1,0,6,3,0.75,1.125,-0.0625,0,,0,0\n"
              "3,2.5,6,2,1,2,0,1,1e-10,0,0\n");
}

TEST(Csv, StressGolden) {
    RunRecord run = synthetic_run();
    run.frames[0].effort.energy = 7.25;
    run.frames[0].effort.stress << 0.75, 0.125, 0.125, 1.25;
    run.frames[0].shear_modulus = 0.5;
    run.frames[1].effort.strain = 0.25;
    EXPECT_EQ(stress_csv(run),
              "frame,time,strain,energy,stress_xx,stress_xy,stress_yy,normal_stress_difference,"
              "shear_modulus\n"
              "1,0,0,7.25,0.75,0.125,1.25,-0.5,0.5\n"
              "3,2.5,0.25,0,0,0,0,0,\n");
}

TEST(Csv, EventsGolden) {
    RunRecord run = synthetic_run();
    run.frames[0].effort.events = {{TopologyEventKind::T1, 0.25, {1.5, -0.5}, {7, 3, 2, 5}},
                                   {TopologyEventKind::Birth, 0.5, {1.0, 2.0}, {8, 1}}};
    run.frames[1].effort.events = {{TopologyEventKind::T2, 2.0, {0.125, 3.0}, {4}}};
    EXPECT_EQ(events_csv(run),
              "frame,time,kind,x,y,bubbles\n"
              "1,0.25,T1,1.5,-0.5,7 3 2 5\n"
              "1,0.5,birth,1,2,8 1\n"
              "3,2,T2,0.125,3,4\n");
}

// The lone bubble has the radius 1. Bubble 5 of a honeycomb is a regular hexagon of area 1.
TEST(Csv, ListsTheBubblesOfTheLastFrame) {
    RunRecord run = synthetic_run();
    const std::string names =
        "frame,identity,x,y,sides,area,target_area,pressure,perimeter,elongation,orientation\n";
    EXPECT_EQ(bubbles_csv(run), names);
    Frame frame;
    frame.number = 12;
    frame.lone_bubbles = {{.identity = 9, .center = {1.5, 2.0}, .target_area = std::numbers::pi}};
    run.last_frame = std::make_shared<const Frame>(frame);
    EXPECT_EQ(bubbles_csv(run),
              names + "12,9,1.5,2,0,3.141592653589793,3.141592653589793,1,6.283185307179586,1,0\n");
    run.last_frame = std::make_shared<const Frame>(snapshot(honeycomb(4, 4), 3));
    const std::string csv = bubbles_csv(run);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 16);
    const std::size_t row = csv.find("\n3,5,");
    ASSERT_NE(row, std::string::npos);
    std::istringstream columns(csv.substr(row + 1, csv.find('\n', row + 1) - row - 1));
    std::vector<double> values;
    for (std::string column; std::getline(columns, column, ',');) {
        values.push_back(std::stod(column));
    }
    ASSERT_EQ(values.size(), 11U);
    EXPECT_EQ(values[4], 6.0);
    EXPECT_NEAR(values[5], 1.0, 1e-12);
    EXPECT_NEAR(values[8], 6.0 * std::sqrt(2.0 / (3.0 * std::sqrt(3.0))), 1e-12);
    EXPECT_NEAR(values[9], 1.0, 1e-6);
}

TEST(Csv, MazesGolden) {
    EXPECT_EQ(maze_csv(synthetic_run()), "");
    RunRecord run = synthetic_run();
    run.frames[0].maze = {3, 2, 1};
    run.frames[1].maze = {2, 0, 0};
    EXPECT_EQ(maze_csv(run),
              "frame,time,bubbles,solution,dead_ends,branches\n"
              "1,0,4,3,2,1\n"
              "3,2.5,2,2,0,0\n");
}

TEST(Csv, DoesNotDependOnTheLocale) {
    const CommaLocale locale;
    EXPECT_EQ(frames_csv(synthetic_run()), kFrames);
}

TEST(Csv, OfNoFrameIsTheLineOfNames) {
    const std::string csv = frames_csv({});
    EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

}  // namespace
}  // namespace foam::texgen
