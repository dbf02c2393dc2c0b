#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {

/// A value as TOML writes it, independent of the library that reads it.
struct Value {
    struct Table {};  // [a.b] or {...}; its entries are keys of their own
    struct Opaque {   // a date or a time, which no key takes
        std::string text;
    };
    using List = std::vector<Value>;

    std::variant<bool, std::int64_t, double, std::string, List, Table, Opaque> data;
};

/// The value in TOML; reading it gives the same value again, to the last bit of a real.
std::string to_toml(const Value& value);

}  // namespace foam::texgen
