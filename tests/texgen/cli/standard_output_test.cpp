// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/standard_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace foam::texgen {
namespace {

constexpr std::string_view kDangerous = "out/\033[31ma.png\n";

// Returns what the terminal receives if the text is written with a pseudo-terminal as stdout.
std::string shown_on_terminal(std::string_view text) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(grantpt(terminal), 0);
    EXPECT_EQ(unlockpt(terminal), 0);
    const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    std::fflush(stdout);
    const int before = dup(STDOUT_FILENO);
    dup2(end, STDOUT_FILENO);
    write_stdout(text);
    std::fflush(stdout);
    dup2(before, STDOUT_FILENO);
    close(before);
    std::array<char, 100> buffer{};
    const ssize_t size = read(terminal, buffer.data(), buffer.size());
    close(end);
    close(terminal);
    return {buffer.data(), static_cast<std::size_t>(size)};
}

TEST(StandardOutput, CannotControlATerminal) {
    EXPECT_EQ(shown_on_terminal(kDangerous), "out/?[31ma.png\r\n");
}

TEST(StandardOutput, IsWrittenUnchangedToFiles) {
    testing::internal::CaptureStdout();
    write_stdout(kDangerous);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), kDangerous);
}

}  // namespace
}  // namespace foam::texgen
