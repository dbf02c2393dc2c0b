// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <string_view>

namespace foam::texgen {

/// Returns true if a file name ends with a suffix such as ".png", in letters of either case.
/// Precondition: the suffix is in lower case.
inline bool has_suffix(std::string_view file_name, std::string_view suffix) {
    const auto lower = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    return file_name.size() >= suffix.size() &&
           std::ranges::equal(
               file_name.substr(file_name.size() - suffix.size()), suffix, {}, lower);
}

}  // namespace foam::texgen
