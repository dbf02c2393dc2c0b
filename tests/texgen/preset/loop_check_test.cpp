// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/loop_check.h"

#include "tests/texgen/preset/rejection.h"
#include "texgen/preset/preset_io.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace foam::texgen {

namespace {

std::string failure(const std::string& toml) {
    return test::rejection_of([&] { parse_preset(toml, "test", "test.toml"); });
}

TEST(LoopCheck, LoopsThatCloseAreAccepted) {
    EXPECT_EQ(failure("[loop]\nkind = 'breathe'\namplitude = 0.2\ndrift = [1, -2]\n"),
              "no failure");
    EXPECT_EQ(failure("[loop]\nkind = 'shear'\namplitude = 0.1\n"), "no failure");
    EXPECT_EQ(failure("[frames]\ncount = 10\n[loop]\nkind = 'boil'\n"), "no failure");
    EXPECT_EQ(failure("[loop]\nkind = 'drift'\ndrift = [0, 1]\n"), "no failure");
    EXPECT_EQ(failure("[frames]\ncount = 24\n[loop]\nkind = 'pingpong'\n"), "no failure");
    EXPECT_EQ(failure("[foam]\ndomain = 'patch'\n[loop]\nkind = 'breathe'\n"), "no failure");
    for (const char* kind : {"none", "breathe", "boil", "flow", "pingpong"}) {
        EXPECT_EQ(failure(fmt::format("[loop]\nkind = '{}'\ncurrent = 0.3\neddies = 2\n", kind)),
                  "no failure");
    }
    EXPECT_EQ(failure("[loop]\nkind = 'flow'\nfade = 1\ngrowth = 12\ndrift = [1, 0]\n"),
              "no failure");
}

TEST(LoopCheck, RejectsLoopsThatCannotClose) {
    EXPECT_EQ(
        failure("[frames]\ncount = 9\n[loop]\nkind = 'boil'\n"),
        "test.toml:4: key 'loop.kind' = \"boil\": the loop \"boil\" needs frames.count of at "
        "least 10: each boiling bubble is absent for a tenth of the loop, which must be at least "
        "one frame");
    EXPECT_EQ(failure("[loop]\nkind = 'boil'\ncycles = 1\n"),
              "test.toml:3: key 'loop.cycles' = 1: the loop \"boil\" needs loop.cycles of at least "
              "2, because it is closed only when two cycles in a row return to their start");
    EXPECT_EQ(failure("[loop]\nkind = 'drift'\n"),
              "test.toml:2: key 'loop.kind' = \"drift\": the loop \"drift\" needs loop.drift; [0, "
              "1], for example, moves the foam up by the height of one image");
    EXPECT_EQ(failure("[loop]\ndrift = [0, 1]\n"),
              "test.toml:2: key 'loop.drift' = [0, 1]: loop.drift is only allowed with loop.kind = "
              "\"drift\", \"breathe\", \"shear\", \"boil\" or \"flow\"");
    EXPECT_EQ(failure("[frames]\ncount = 25\n[loop]\nkind = 'pingpong'\n"),
              "test.toml:4: key 'loop.kind' = \"pingpong\": the loop \"pingpong\" needs an even "
              "frames.count: it shows the first and the last state once and all states between "
              "them twice");
    EXPECT_EQ(failure("[loop]\nkind = 'shear'\namplitude = 0.5\n"),
              "test.toml:3: key 'loop.amplitude' = 0.5: loop.amplitude must be at most 0.4 with "
              "loop.kind = \"shear\"");
    EXPECT_EQ(failure("[foam]\ndomain = 'patch'\n[loop]\nkind = 'shear'\n"),
              "test.toml:4: key 'loop.kind' = \"shear\": the loops \"shear\" and \"drift\" need "
              "foam.domain = \"torus\"");
    EXPECT_EQ(failure("[frames]\nfirst = 'diagram'\n[loop]\nkind = 'breathe'\n"),
              "test.toml:4: key 'loop.kind' = \"breathe\": frames.first = \"diagram\" is only "
              "allowed with loop.kind = \"none\" or \"pingpong\"");
    EXPECT_EQ(failure("[loop]\nkind = 'breathe'\n[[event]]\nkind = 'collapse'\nsides = 5\n"
                      "frame = 3\n"),
              "test.toml:2: key 'loop.kind' = \"breathe\": events are only allowed with loop.kind "
              "= \"none\" or \"pingpong\"");
    EXPECT_EQ(failure("[foam]\ndomain = 'patch'\n[loop]\nkind = 'flow'\n"),
              "test.toml:4: key 'loop.kind' = \"flow\": the loop \"flow\" needs foam.domain = "
              "\"torus\": a patch loses gas and has no steady state");
    EXPECT_EQ(failure("[frames]\ntime_step = 0\n[loop]\nkind = 'flow'\n"),
              "test.toml:4: key 'loop.kind' = \"flow\": the loop \"flow\" needs frames.time_step "
              "above 0: if no time passes, no gas diffuses and no bubble vanishes");
    EXPECT_EQ(failure("[loop]\nkind = 'flow'\n[frames]\nstep_growth = 1.1\n"),
              "test.toml:4: key 'frames.step_growth' = 1.1: the loop \"flow\" needs "
              "frames.step_growth = 1: its speed is constant");
    EXPECT_EQ(failure("[loop]\nkind = 'flow'\nfade = 0\n"),
              "test.toml:3: key 'loop.fade' = 0: must be a number from 0.01 to 1");
    EXPECT_EQ(
        failure("[foam]\nbubbles = 48\n[loop]\ncurrent = 0.2\neddies = 3\n"),
        "test.toml:5: key 'loop.eddies' = 3: loop.eddies must be at most 2 for 48 bubbles, so "
        "that an eddy is at least 3 bubbles wide");
    EXPECT_EQ(
        failure("[foam]\ndomain = 'patch'\n[loop]\ncurrent = 0.2\n"),
        "test.toml:4: key 'loop.current' = 0.2: loop.current is only allowed with foam.domain = "
        "\"torus\"");
    EXPECT_EQ(failure("[loop]\ndrift = [0.5, 1]\n"),
              "test.toml:2: key 'loop.drift' = [0.5, 1]: must be [x, y], each an integer from -100 "
              "to 100");
}

}  // namespace
}  // namespace foam::texgen
