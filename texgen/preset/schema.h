#pragma once

#include "texgen/preset/preset.h"
#include "texgen/preset/value.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// One key of the preset: all that reading, checking, writing and documenting it needs.
struct Key {
    std::string_view path;  // "foam.bubbles": table and name
    std::string allowed;    // "an integer from 4 to 1000000"
    std::string_view meaning;
    std::function<bool(const Value&, Preset&)> read;  // false: not allowed, nothing changed
    std::function<Value(const Preset&)> write;
    std::optional<FoamKind> kind = {};  // the only kind of foam that takes another than the default

    std::string_view table() const { return path.substr(0, path.find('.')); }
    std::string_view name() const { return path.substr(path.find('.') + 1); }
};

/// Every key there is, table by table.
std::span<const Key> preset_keys();

/// nullptr where there is none of this path.
const Key* find_key(std::string_view path);

/// Whether some key stands in a table of this name.
bool is_table(std::string_view name);

/// The word for a kind: "patch".
std::string_view name_of(FoamKind kind);

}  // namespace foam::texgen
