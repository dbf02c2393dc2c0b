// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/external_program.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

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

TEST(ExternalProgram, WritesItsErrorsToAFile) {
    const TemporaryFolder folder;
    const std::filesystem::path errors = folder.path() / "errors";
    EXPECT_EQ(run_external({"sh", "-c", "echo wrong >&2"}, {.error_file = errors}), 0);
    EXPECT_EQ(std::filesystem::file_size(errors), std::string("wrong\n").size());
}

TEST(ExternalProgram, AMissingFolderIsAnError) {
    const TemporaryFolder folder;
    const std::string missing = (folder.path() / "missing").string();
    try {
        run_external({"sh", "-c", "exit 0"}, {.folder = missing});
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot start the program 'sh': its working directory '" + missing +
                      "' does not exist");
    }
}

// A shell would make two words of the name.
TEST(ExternalProgram, RunsInAFolderWithoutAShell) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_external({"touch", "a b; $c"}, {.folder = folder.path()}), 0);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a b; $c"});
}

}  // namespace
}  // namespace foam::texgen
