// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/progress.h"

#include "tests/texgen/cli/pseudo_terminal.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/cli/interruption.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

RunProgress frames_done(int done, int total) {
    return {.phase = Phase::Frames, .done = done, .total = total, .frame = done, .bubbles = 9};
}

/// Returns what a reporter writes to stderr, which is not a terminal.
std::string reported(const ProgressOptions& options, const std::vector<RunProgress>& reports) {
    testing::internal::CaptureStderr();
    {
        ProgressReporter reporter(options);
        const ProgressCallback report = reporter.callback();
        std::ranges::for_each(reports, report);
    }
    return testing::internal::GetCapturedStderr();
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(Progress, WithoutATerminalNothingIsPrinted) {
    const std::vector<RunProgress> reports = {frames_done(0, 2), frames_done(2, 2)};
    EXPECT_EQ(reported({}, reports), "");
    EXPECT_EQ(reported({.verbosity = Verbosity::Quiet, .json = true}, reports), "");
}

TEST(Progress, JsonHasTheFirstAndTheLastReportOfAFastRun) {
    const std::vector<std::string> lines =
        lines_of(reported({.json = true},
                          {{.phase = Phase::Seeding},
                           frames_done(0, 3),
                           frames_done(1, 3),
                           frames_done(2, 3),
                           frames_done(3, 3),
                           frames_done(3, 3)}));  // repeated, as between two frames
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(nlohmann::json::parse(lines[0])["phase"], "seeding");
    EXPECT_EQ(nlohmann::json::parse(lines[1])["done"], 3);
}

TEST(Progress, JsonHasALinePerSecond) {
    testing::internal::CaptureStderr();
    {
        ProgressReporter reporter({.json = true});
        const ProgressCallback report = reporter.callback();
        for (int done = 0; done <= 25; ++done) {
            report(frames_done(done, 25));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
    // At 0 s, 1 s, 2 s and at the end, if the machine is not slower than the reports.
    std::vector<double> seconds;
    for (const std::string& line : lines_of(testing::internal::GetCapturedStderr())) {
        seconds.push_back(nlohmann::json::parse(line)["seconds"]);
    }
    ASSERT_GE(seconds.size(), 4U);
    for (std::size_t k = 1; k + 1 < seconds.size(); ++k) {
        EXPECT_GE(seconds[k] - seconds[k - 1], 0.999);
    }
}

// The only report is repeated at 1 s and 2 s.
TEST(Progress, ALongStepIsNotSilent) {
    const auto wait = [](const ProgressOptions& options) {
        ProgressReporter reporter(options);
        reporter.callback()({.phase = Phase::Equilibrium});
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    };
    testing::internal::CaptureStderr();
    wait({.json = true});
    const std::vector<std::string> lines = lines_of(testing::internal::GetCapturedStderr());
    ASSERT_GE(lines.size(), 2U);
    const nlohmann::json last = nlohmann::json::parse(lines.back());
    EXPECT_EQ(last["phase"], "equilibrium");
    EXPECT_GE(last["seconds"], 0.999);
    testing::internal::CaptureStderr();
    wait({});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(shown_on_terminal(STDERR_FILENO, [&] { wait({}); }).find("equilibrium  0:01 so far"),
              std::string::npos);
}

TEST(Progress, VerboseHasALinePerFrameAndPerCycle) {
    const auto closing = [](int cycle, int done) {
        return RunProgress{.phase = Phase::LoopClosing, .done = done, .total = 2, .cycle = cycle};
    };
    const std::vector<std::string> lines = lines_of(reported({.verbosity = Verbosity::Verbose},
                                                             {closing(1, 0),
                                                              closing(1, 1),
                                                              closing(1, 2),
                                                              closing(2, 0),
                                                              closing(2, 1),
                                                              closing(2, 2),
                                                              frames_done(0, 2),
                                                              frames_done(1, 2),
                                                              frames_done(1, 2),
                                                              frames_done(2, 2)}));
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0].find("closing the loop: cycle 1 (0/2), "), 0U);
    EXPECT_EQ(lines[1].find("closing the loop: cycle 1 (2/2), "), 0U);
    EXPECT_EQ(lines[2].find("closing the loop: cycle 2 (2/2), "), 0U);
    EXPECT_EQ(lines[3].find("frame 1: 9 bubbles, "), 0U);
    EXPECT_EQ(lines[4].find("frame 2: 9 bubbles, "), 0U);
}

TEST(Progress, TheBarIsDrawnOnATerminalAndItsLineEnds) {
    setenv("NO_COLOR", "1", 1);
    const auto draw = [] {
        ProgressReporter reporter({});
        reporter.callback()(frames_done(0, 2));
        reporter.callback()(frames_done(2, 2));  // too soon to be drawn, but it is the last one
    };
    EXPECT_EQ(shown_on_terminal(STDERR_FILENO, draw),
              "\r\033[K[------------------------] frame 0 of 2  9 bubbles"
              "\r\033[K[########################] frame 2 of 2  9 bubbles\r\n");
    unsetenv("NO_COLOR");
    EXPECT_NE(shown_on_terminal(STDERR_FILENO, draw).find("\033[36m["), std::string::npos);
}

// Two units take at least 2.2 s, and 98 units are left: about two minutes or more.
TEST(Progress, ALongRunIsNotedOnce) {
    const auto run = [](const ProgressOptions& options) {
        testing::internal::CaptureStderr();
        {
            ProgressReporter reporter(options);
            const ProgressCallback report = reporter.callback();
            report(frames_done(0, 100));
            for (const int done : {1, 2, 3}) {
                std::this_thread::sleep_for(std::chrono::milliseconds(done < 3 ? 1100 : 0));
                report(frames_done(done, 100));
            }
        }
        return testing::internal::GetCapturedStderr();
    };
    const std::string note = run({});
    EXPECT_TRUE(note.starts_with("foamtex: note: this takes about ")) << note;
    EXPECT_TRUE(note.ends_with(" minutes more\n")) << note;
    EXPECT_EQ(std::ranges::count(note, '\n'), 1);
    EXPECT_EQ(run({.verbosity = Verbosity::Quiet}), "");
    EXPECT_EQ(run({.json = true}).find("note"), std::string::npos);
}

// Each step takes at least 0.3 s. The first eight steps are two of 60 cycles; 232 steps are left.
TEST(Progress, ALongSearchForALoopIsNoted) {
    testing::internal::CaptureStderr();
    {
        ProgressReporter reporter({});
        const ProgressCallback report = reporter.callback();
        for (int step = 0; step <= 8; ++step) {
            report({.phase = Phase::LoopClosing,
                    .done = step % 4,
                    .total = 4,
                    .cycle = 1 + step / 4,
                    .usual_cycles = 60});
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
        }
    }
    const std::string note = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(note.starts_with("foamtex: note: this takes about ")) << note;
    EXPECT_EQ(std::ranges::count(note, '\n'), 1);
}

TEST(Progress, ASignalStopsEveryPhaseThatIsNotFinished) {
    testing::internal::CaptureStderr();
    for (const Phase phase : {Phase::Seeding, Phase::LoopClosing, Phase::Ranges, Phase::Files}) {
        ProgressReporter reporter({});
        const ProgressCallback report = reporter.callback();
        report({.phase = phase, .done = 1, .total = 2});
        std::raise(SIGTERM);
        EXPECT_THROW(report({.phase = phase, .done = 1, .total = 2}), Interrupted);
        EXPECT_NO_THROW(report({.phase = phase, .done = 2, .total = 2}));
    }
    handle_stop_signals();  // forgets the signal
    testing::internal::GetCapturedStderr();
}

TEST(Progress, EveryLongCommandHasJsonLines) {
    const TemporaryFolder folder;
    const std::string small =
        " sea_foam --set foam.bubbles=16 --set frames.count=4 --size 64 --maps height ";
    const std::string json = " --progress json";
    const std::vector<std::pair<std::string, std::string>> commands = {
        {"bake" + small, "frames"},
        {"simulate sea_foam --set foam.bubbles=16 --frames 1-3 --cache cache", "frames"},
        {"render cache --size 32 --out r/{map}.####.png", "frames"},
        {"stats cache --out s", "frames"},
        {"verify out", "files"},
        {"flipbook out", "sheets"},
        {"preview out", "previews"},
        {"preview" + small + "-o shown", "previews"}};
    for (const auto& [command, last_phase] : commands) {
        const Outcome outcome = run_program(command + json, folder);
        EXPECT_EQ(outcome.code, 0) << command << outcome.err;
        std::vector<nlohmann::json> reports;
        for (const std::string& line : lines_of(outcome.err)) {
            if (line.starts_with("{")) {
                reports.push_back(nlohmann::json::parse(line));
            }
        }
        ASSERT_GE(reports.size(), 2U) << command;
        EXPECT_EQ(reports.back()["phase"], last_phase) << command;
        EXPECT_EQ(reports.back()["done"], reports.back()["total"]) << command;
        EXPECT_LE(reports.front()["seconds"], reports.back()["seconds"]) << command;
    }
    expect_rejected("bake sea_foam --progress json -q",
                    "--quiet excludes --progress (see foamtex bake --help)");
    expect_rejected("bake sea_foam --progress json -v",
                    "--verbose excludes --progress (see foamtex bake --help)");
}

}  // namespace
}  // namespace foam::texgen
