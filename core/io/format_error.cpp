// SPDX-License-Identifier: Apache-2.0

#include "core/io/format_error.h"

#include <fmt/core.h>

#include <algorithm>

namespace foam {

namespace {

// Replaces characters that are not printable ASCII by question marks, because a message may quote
// arbitrary bytes of a file.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

}  // namespace

FormatError::FormatError(const std::string& file, int line, const std::string& message)
    : std::runtime_error(fmt::format("{}:{}: {}", file, line, printable(message))), line_(line) {}

}  // namespace foam
