// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/value.h"

#include "core/files/shown_text.h"

#include <fmt/core.h>

#include <string_view>

namespace foam::texgen {

namespace {

/// Returns a character as it is written in a basic string of TOML.
std::string escaped(char c) {
    switch (c) {
        case '"':
            return "\\\"";
        case '\\':
            return "\\\\";
        case '\n':
            return "\\n";
        case '\t':
            return "\\t";
        default: {
            const auto code = static_cast<unsigned char>(c);
            const bool control = code < 0x20 || code == 0x7f;
            return control ? fmt::format("\\u{:04x}", code) : std::string(1, c);
        }
    }
}

/// Converts the data of a value to TOML, one overload per type.
struct Writer {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }

    /// Returns the shortest digits that parse to the same number. Adds ".0" if TOML would parse
    /// them as an integer.
    std::string operator()(double real) const {
        std::string digits = fmt::format("{}", real);
        const bool looks_integer = digits.find_first_not_of("-0123456789") == std::string::npos;
        return looks_integer ? digits + ".0" : digits;
    }

    /// Replaces bytes that are not UTF-8, because TOML must be UTF-8. A string may have such bytes
    /// if it contains the name of a folder.
    std::string operator()(const std::string& text) const {
        std::string quoted = "\"";
        for (const char c : valid_utf8(text)) {
            quoted += escaped(c);
        }
        return quoted + '"';
    }

    std::string operator()(const Value::List& list) const {
        std::string joined;
        for (const Value& item : list) {
            joined += (joined.empty() ? "" : ", ") + to_toml(item);
        }
        return '[' + joined + ']';
    }

    std::string operator()(const Value::Table& /*table*/) const { return "{...}"; }
    std::string operator()(const Value::Opaque& opaque) const { return opaque.text; }
};

}  // namespace

std::string to_toml(const Value& value) {
    return std::visit(Writer{}, value.data);
}

}  // namespace foam::texgen
