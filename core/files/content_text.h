// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

namespace foam {

/// Returns bytes, such as the content of a file, as text. The text refers to the bytes.
inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns a text without the given characters, by default spaces, tabs and line breaks, at its
/// beginning and its end. The result refers to the text.
inline std::string_view trimmed(std::string_view text, std::string_view spaces = " \t\r\n") {
    const std::size_t first = std::min(text.find_first_not_of(spaces), text.size());
    return text.substr(first, text.find_last_not_of(spaces) + 1 - first);
}

}  // namespace foam
