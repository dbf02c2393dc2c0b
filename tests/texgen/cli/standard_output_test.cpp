// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/standard_output.h"

#include "tests/texgen/cli/pseudo_terminal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

namespace foam::texgen {
namespace {

constexpr std::string_view kDangerous = "out/\033[31ma.png\n";

TEST(StandardOutput, CannotControlATerminal) {
    std::fflush(stdout);
    const std::string shown = shown_on_terminal(STDOUT_FILENO, [] {
        write_stdout(kDangerous);
        std::fflush(stdout);
    });
    EXPECT_EQ(shown, "out/?[31ma.png\r\n");
}

TEST(StandardOutput, IsWrittenUnchangedToFiles) {
    testing::internal::CaptureStdout();
    write_stdout(kDangerous);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), kDangerous);
}

}  // namespace
}  // namespace foam::texgen
