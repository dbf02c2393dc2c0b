// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/key.h"

#include <fmt/core.h>

#include <algorithm>

namespace foam::texgen {

bool Condition::allows(std::string_view value) const {
    return std::find(values.begin(), values.end(), value) != values.end();
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
