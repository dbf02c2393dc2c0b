// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace foam::bench {

/// Parses the command line `PROGRAM [LARGEST]` of a benchmark that prints tables. Returns LARGEST,
/// or `default_value` if it is not given. For --help, prints the usage and exits with code 0. If
/// the arguments are anything but one positive integer, prints one line on stderr and exits with
/// code 2.
inline int largest_argument(int argc, char** argv, int default_value, std::string_view usage) {
    if (argc < 2) {
        return default_value;
    }
    const std::string_view text = argv[1];
    if (text == "--help" || text == "-h") {
        fmt::print("{}", usage);
        std::exit(EXIT_SUCCESS);
    }
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (argc > 2 || error != std::errc() || end != text.data() + text.size() || value < 1) {
        fmt::print(stderr,
                   "{}: the only argument is the largest number of bubbles, from 1 on, or --help\n",
                   argv[0]);
        std::exit(2);
    }
    return value;
}

}  // namespace foam::bench
