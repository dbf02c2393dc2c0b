// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/external_program.h"

#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(ExternalProgram, ReturnsTheExitCode) {
    EXPECT_EQ(run_external({"sh", "-c", "exit 0"}), 0);
    EXPECT_EQ(run_external({"sh", "-c", "exit 7"}), 7);
    EXPECT_EQ(run_external({"sh", "-c", "kill -9 $$"}), -1);
}

TEST(ExternalProgram, AMissingProgramIsNoError) {
    EXPECT_FALSE(run_external({"no-such-program-anywhere"}));
}

// A shell would make two words of the name.
TEST(ExternalProgram, RunsInAFolderWithoutAShell) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_external({"touch", "a b; $c"}, {.folder = folder.path()}), 0);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a b; $c"});
}

}  // namespace
}  // namespace foam::texgen
