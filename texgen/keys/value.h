// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {

/// A TOML value, independent of the library that parses it.
struct Value {
    /// A table, written [a.b] or {...}. Its entries are separate keys and not part of this value.
    struct Table {
        friend bool operator==(const Table&, const Table&) = default;
    };
    /// A date or a time as text. No key allows such a value.
    struct Opaque {
        std::string text;
        friend bool operator==(const Opaque&, const Opaque&) = default;
    };
    using List = std::vector<Value>;

    std::variant<bool, std::int64_t, double, std::string, List, Table, Opaque> data;

    friend bool operator==(const Value& a, const Value& b) { return a.data == b.data; }
};

/// Returns the value as TOML. Parsing the text gives an equal value; real numbers are equal to the
/// last bit. There are two exceptions: the text of a table is "{...}", and bytes of a string that
/// are not UTF-8 are replaced.
std::string to_toml(const Value& value);

}  // namespace foam::texgen
