#include "core/io/format_error.h"

#include <fmt/core.h>

#include <algorithm>

namespace foam {

namespace {

// A message may quote what a file holds, and that may be anything.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

}  // namespace

FormatError::FormatError(const std::string& file, int line, const std::string& message)
    : std::runtime_error(fmt::format("{}:{}: {}", file, line, printable(message))), line_(line) {}

}  // namespace foam
