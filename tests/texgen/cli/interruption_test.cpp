// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/interruption.h"

#include "tests/support/places.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/manifest/manifest_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <string>

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
              "\nfoamtex: stopping after the current frame; a second signal stops at once\n"
              "foamtex: the same command with --resume goes on\n"
              "foamtex: interrupted\n");
    const BakedSet set = choose_set(read_manifest(folder.path()), "", folder.path());
    EXPECT_EQ(set.failure, "interrupted");
    EXPECT_FALSE(set.files.empty());
    const Outcome resumed =
        run_program("--version > /dev/null && '" + foam::test::executable().string() + kLongBake +
                        " --frames 1-2 --resume -q",
                    folder);
    EXPECT_EQ(resumed.code, 0) << resumed.err;
}

TEST(Interruption, SigtermHasItsOwnExitCode) {
    const TemporaryFolder folder;
    const Outcome outcome = stopped_by("TERM", folder);
    EXPECT_EQ(outcome.code, 143);
    EXPECT_TRUE(outcome.err.ends_with("foamtex: terminated\n")) << outcome.err;
}

TEST(Interruption, WithoutASignalNothingIsThrown) {
    EXPECT_NO_THROW(throw_if_interrupted());
    EXPECT_EQ(Interrupted(SIGTERM).signal(), SIGTERM);
}

}  // namespace
}  // namespace foam::texgen
