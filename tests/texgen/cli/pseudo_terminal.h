// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <string>

namespace foam::texgen {

/// Returns what a terminal receives while `action` runs with a pseudo-terminal as `stream`, which
/// is STDOUT_FILENO or STDERR_FILENO.
inline std::string shown_on_terminal(int stream, const std::function<void()>& action) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(grantpt(terminal), 0);
    EXPECT_EQ(unlockpt(terminal), 0);
    const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    const int before = dup(stream);
    dup2(end, stream);
    action();
    dup2(before, stream);
    close(before);
    std::string shown;
    std::array<char, 1000> buffer{};
    // The terminal passes texts on without delay, one or several at a time.
    for (pollfd waiting{terminal, POLLIN, 0}; poll(&waiting, 1, 200) == 1;) {
        const ssize_t size = read(terminal, buffer.data(), buffer.size());
        shown.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    }
    close(end);
    close(terminal);
    return shown;
}

}  // namespace foam::texgen
