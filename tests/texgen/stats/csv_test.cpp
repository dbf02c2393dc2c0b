// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/csv.h"

#include <gtest/gtest.h>

#include <locale>
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
