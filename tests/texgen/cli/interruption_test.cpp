// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/interruption.h"

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/set_choice.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// A bake that takes minutes.
constexpr const char* kLongBake =
    "' bake sea_foam --set loop.kind=none --set foam.bubbles=16 --set frames.count=100000 --size 8 "
    "--out a.######.png";

// Sends a signal to the bake as soon as it has written a frame. The exit code is that of the bake.
Outcome stopped_by(const std::string& signal, const TemporaryFolder& folder) {
    return run_program("--version > /dev/null; { '" + foam::test::executable().string() +
                           kLongBake +
                           " & until [ -e a.000001.png ] || ! kill -0 $!; do sleep 0.02; done; "
                           "kill -" +
                           signal + " $!; wait $!; }",
                       folder);
}

TEST(Interruption, ABakeRecordsItsFramesAndSaysHowToGoOn) {
    const TemporaryFolder folder;
    const Outcome outcome = stopped_by("INT", folder);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err,
              "\nfoamtex: stopping after the current step; the same signal again stops at once\n"
              "foamtex: to continue, run the same command with --resume\n"
              "foamtex: interrupted\n");
    const BakedSet set = newest_set(read_manifest(folder.path()), {}, folder.path());
    EXPECT_EQ(set.failure, "interrupted");
    EXPECT_FALSE(set.files.empty());
    const Outcome resumed =
        run_program("--version > /dev/null && '" + foam::test::executable().string() + kLongBake +
                        " --frames 1-2 --resume -q",
                    folder);
    EXPECT_EQ(resumed.code, 0) << resumed.err;
}

TEST(Interruption, TheStudioHasNoStepsToWaitFor) {
    const Outcome outcome =
        run_program("--version > /dev/null; { '" + foam::test::executable().string() +
                    "' studio --no-browser --json > url & until [ -s url ] || ! kill -0 $!; do "
                    "sleep 0.02; done; sleep 0.5; kill -TERM $!; wait $!; }");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "\nfoamtex: stopping; the same signal again stops at once\n");
}

TEST(Interruption, AnIncompleteCacheIsMentioned) {
    const Outcome outcome =
        run_program("--version > /dev/null; { '" + foam::test::executable().string() +
                    "' simulate sea_foam --set loop.kind=none --set foam.bubbles=16 "
                    "--set frames.count=100000 --size 8 --cache c & "
                    "until [ -e c/state.000001.foam ] || ! kill -0 $!; do sleep 0.02; done; "
                    "kill -INT $!; wait $!; }");
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(
        outcome.err.ends_with("foamtex: the cache may be incomplete; to simulate the foam again "
                              "from the start, run the same command\nfoamtex: interrupted\n"))
        << outcome.err;
}

TEST(Interruption, SigtermHasItsOwnExitCode) {
    const TemporaryFolder folder;
    const Outcome outcome = stopped_by("TERM", folder);
    EXPECT_EQ(outcome.code, 143);
    EXPECT_TRUE(outcome.err.ends_with("foamtex: terminated\n")) << outcome.err;
}

// The tests themselves may have been started with nohup, and processes inherit ignored signals.
TEST(Interruption, AClosedTerminalHasItsOwnExitCode) {
    const TemporaryFolder folder;
    const auto previous = std::signal(SIGHUP, SIG_DFL);
    const Outcome outcome = stopped_by("HUP", folder);
    std::signal(SIGHUP, previous);
    EXPECT_EQ(outcome.code, 129);
    EXPECT_TRUE(outcome.err.ends_with("foamtex: hung up\n")) << outcome.err;
}

// A program that nohup starts ignores SIGHUP, too.
TEST(Interruption, AnIgnoredSignalStaysIgnored) {
    const Outcome outcome = run_program(
        "--version > /dev/null; trap '' HUP; { '" + foam::test::executable().string() +
        "' bake sea_foam -q --set foam.bubbles=16 --set loop.kind=none --set frames.count=300 "
        "--size 8 --out a.###.png & until [ -e a.001.png ] || ! kill -0 $!; do sleep 0.01; done; "
        "kill -HUP $!; wait $!; }");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.written.size(), 301U);
}

// Sends SIGINT to a bake as soon as its verbose output on stderr contains a text.
Outcome stopped_in_phase(const std::string& arguments, const std::string& text) {
    return run_program("--version > /dev/null; { '" + foam::test::executable().string() +
                       "' bake sea_foam -v --set foam.bubbles=100 --set frames.count=20000 "
                       "--size 8 --out a.######.png " +
                       arguments + " 2>err & until grep -q '" + text +
                       "' err || ! kill -0 $!; do sleep 0.02; done; kill -INT $!; wait $!; "
                       "code=$?; cat err >&2; (exit $code); }");
}

// The last lines on stderr if a bake stops before its first frame.
constexpr const char* kNothingToResume =
    "foamtex: no frame was written; to start again, run the same command\n"
    "foamtex: interrupted\n";

TEST(Interruption, ALoopThatIsBeingClosedStops) {
    const Outcome outcome = stopped_in_phase("", "closing the loop: cycle 1");
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(outcome.err.ends_with(kNothingToResume)) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"err"}));
}

TEST(Interruption, RangesThatAreBeingFittedStop) {
    const Outcome outcome =
        stopped_in_phase("--maps height --set loop.kind=none", "ranges: frame 0 of 20000");
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(outcome.err.ends_with(kNothingToResume)) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"err"}));
}

// The handler cannot write its note, which sets errno.
TEST(Interruption, TheInterruptedCodeKeepsItsErrno) {
    const auto run = [] {
        handle_stop_signals(Stopping::Soon);
        close(STDERR_FILENO);
        errno = 0;
        std::raise(SIGTERM);
        std::_Exit(errno);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(Interruption, WithoutASignalNothingIsThrown) {
    EXPECT_NO_THROW(throw_if_interrupted());
    EXPECT_EQ(Interrupted(SIGTERM).signal(), SIGTERM);
}

}  // namespace
}  // namespace foam::texgen
