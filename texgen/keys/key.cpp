// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/key.h"

#include "texgen/image/file_suffix.h"

#include <fmt/format.h>

#include <algorithm>

namespace foam::texgen {

bool Condition::allows(std::string_view value) const {
    const bool is_listed = std::ranges::any_of(values, [&](std::string_view listed) {
        return listed.starts_with('*') ? has_suffix(value, listed.substr(1)) : value == listed;
    });
    return is_listed != excludes;
}

std::string text_of(const Condition& condition) {
    const bool are_words = condition.values.front().find_first_of("0123456789[") != 0;
    const std::string_view quote = are_words ? "\"" : "";
    return fmt::format("{0} = {1}{2}{1}",
                       condition.key,
                       quote,
                       fmt::join(condition.values, fmt::format("{0} or {0}", quote)));
}

std::string_view KeyInfo::table() const {
    return std::string_view(path).substr(0, path.find('.'));
}

std::string_view KeyInfo::name() const {
    return std::string_view(path).substr(path.find('.') + 1);
}

std::string describe(const KeyInfo& key) {
    const std::string value =
        key.default_value ? fmt::format(" = {}", to_toml(*key.default_value)) : "";
    return fmt::format("{}{}\n    {}\n    {}\n", key.name(), value, key.meaning, key.allowed);
}

}  // namespace foam::texgen
