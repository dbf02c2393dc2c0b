// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_extension.h"

#include "texgen/keys/value.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>

#include <map>

namespace foam::texgen {

namespace {

// Returns true if a key is in a table, as albedo.colors.from is in the table albedo.colors.
bool is_within(std::string_view key, std::string_view table) {
    return key.size() > table.size() && key.starts_with(table) && key[table.size()] == '.';
}

}  // namespace

std::string extending_preset(std::string_view base, std::span<const Assignment> assignments) {
    std::map<std::string, Value> values;
    for (const Assignment& one : assignments) {
        // A value and a table of the same name, such as albedo.colors, replace each other.
        std::erase_if(values, [&](const auto& earlier) {
            return is_within(earlier.first, one.key) || is_within(one.key, earlier.first);
        });
        values[one.key] = one.value;
    }
    std::string toml = fmt::format("extends = {}\n", to_toml(Value{std::string(base)}));
    std::string_view table;
    for (const Key<Preset>& key : preset_keys()) {
        if (const auto found = values.find(key.path); found != values.end()) {
            if (key.table() != table) {
                table = key.table();
                toml += fmt::format("\n[{}]\n", table);
            }
            toml += fmt::format("{} = {}\n", key.name(), to_toml(found->second));
        }
    }
    return toml;
}

}  // namespace foam::texgen
