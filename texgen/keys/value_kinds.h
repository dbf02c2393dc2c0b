// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

// The kinds of values that keys accept. Each kind is a struct with four functions:
// - allowed() returns a description of the allowed values in words.
// - schema() returns the allowed values as a JSON Schema (draft 2020-12).
// - read() stores a value in a member and returns true. If the value is not allowed, it returns
//   false and changes nothing.
// - write() converts a member back to a value, or returns nullopt if the member is unset.
// Kinds whose values are words also have the function words(), which returns these words. The
// memory of the words must be static. A kind may also have two more functions:
// - fault(value) says why a value is not allowed (KeyInfo::fault).
// - file(member) returns the file that the member names (Key::file).

/// Returns the JSON Schema of a list with `min_items` to `max_items` items. A limit of 0 means that
/// there is no limit. `item` is the schema of an item.
std::string list_schema(const std::string& item, std::size_t min_items, std::size_t max_items);

/// Returns the JSON Schema of the values that at least one of the two schemas allows.
std::string any_of_schema(const std::string& one, const std::string& other);

/// Integers from low to high, stored in any integer type.
struct Integers {
    std::int64_t low = 0;
    std::int64_t high = 0;

    std::string allowed() const;
    std::string schema() const;
    /// Returns the integer of a value, or nullopt if the value is not allowed.
    std::optional<std::int64_t> accepted(const Value& value) const;

    template <class Integer>
    bool read(const Value& value, Integer& member) const {
        const std::optional<std::int64_t> integer = accepted(value);
        member = integer ? static_cast<Integer>(*integer) : member;
        return integer.has_value();
    }
    template <class Integer>
    Value write(Integer member) const {
        return {static_cast<std::int64_t>(member)};
    }
};

/// Finite numbers from low to high, written with or without a decimal point. If `or_zero` is true,
/// the value 0 is also allowed.
struct Reals {
    double low = 0.0;
    double high = 0.0;
    bool or_zero = false;

    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, double& member) const;
    Value write(double member) const { return {member}; }
};

inline constexpr Reals kFractions{0.0, 1.0};

/// A number that a user gives, or that the program finds by itself if the user gives "auto". Until
/// the program has found it, `value` is a typical number.
struct AutoReal {
    double value = 0.0;
    bool is_automatic = false;

    friend bool operator==(const AutoReal&, const AutoReal&) = default;
};

/// The word "auto", or finite numbers from low to high.
struct RealsOrAuto {
    double low = 0.0;
    double high = 0.0;
    AutoReal automatic{0.0, true};  // what `read` stores in the member for "auto"

    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, AutoReal& member) const;
    Value write(const AutoReal& member) const;
};

/// Strings. The empty string is allowed only if `or_empty` is true.
struct Text {
    bool or_empty = false;

    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::string& member) const;
    Value write(const std::string& member) const { return {member}; }
};

/// sRGB colors, written "#rrggbb".
struct Colors {
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::string& member) const;
    Value write(const std::string& member) const { return {member}; }
};

/// Lists of colors, which may be empty. A single color may be written without brackets.
struct ColorLists {
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::vector<std::string>& member) const;
    Value write(const std::vector<std::string>& member) const;
};

/// Strings that are one of the given words.
struct Words {
    std::span<const std::string_view> list;

    std::span<const std::string_view> words() const { return list; }
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::string& member) const;
    Value write(const std::string& member) const { return {member}; }
};

/// Lists of at least one of the given words, each at most once. A single word may be written
/// without brackets.
struct WordLists {
    std::span<const std::string_view> list;

    std::span<const std::string_view> words() const { return list; }
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::vector<std::string>& member) const;
    Value write(const std::vector<std::string>& member) const;
};

/// Lists of at least one integer. An empty vector in the member means that the key is unset. A
/// single integer may be written without brackets.
struct IntegerLists {
    Integers item;

    std::string allowed() const { return item.allowed() + ", or a list of such values"; }
    std::string schema() const {
        return any_of_schema(item.schema(), list_schema(item.schema(), 1, 0));
    }

    template <class Integer>
    bool read(const Value& value, std::vector<Integer>& member) const {
        const auto* list = std::get_if<Value::List>(&value.data);
        std::vector<Integer> found;
        for (const Value& one : list != nullptr ? *list : Value::List{value}) {
            if (!item.read(one, found.emplace_back())) {
                return false;
            }
        }
        if (found.empty()) {
            return false;
        }
        member = std::move(found);
        return true;
    }
    template <class Integer>
    std::optional<Value> write(const std::vector<Integer>& member) const {
        Value::List list;
        for (const Integer one : member) {
            list.push_back(item.write(one));
        }
        return member.empty() ? std::nullopt : std::optional(Value{std::move(list)});
    }
};

/// Pairs [x, y] of numbers of one kind.
template <class Coordinate>
struct Pairs {
    Coordinate coordinate;

    std::string allowed() const { return "[x, y], each " + coordinate.allowed(); }
    std::string schema() const { return list_schema(coordinate.schema(), 2, 2); }

    template <class Number>
    bool read(const Value& value, std::array<Number, 2>& member) const {
        const auto* list = std::get_if<Value::List>(&value.data);
        std::array<Number, 2> pair{};
        const bool allowed = list != nullptr && list->size() == 2 &&
                             coordinate.read(list->front(), pair[0]) &&
                             coordinate.read(list->back(), pair[1]);
        member = allowed ? pair : member;
        return allowed;
    }
    template <class Number>
    Value write(const std::array<Number, 2>& member) const {
        return {Value::List{coordinate.write(member[0]), coordinate.write(member[1])}};
    }
};

using Points = Pairs<Reals>;
using IntegerPairs = Pairs<Integers>;

/// The values of another kind, stored in a member that may be unset.
template <class ValueKind>
struct Maybe {
    ValueKind kind;

    std::string allowed() const { return kind.allowed(); }
    std::string schema() const { return kind.schema(); }

    template <class Member>
    bool read(const Value& value, std::optional<Member>& member) const {
        Member found{};
        const bool allowed = kind.read(value, found);
        member = allowed ? std::optional(found) : member;
        return allowed;
    }
    template <class Member>
    std::optional<Value> write(const std::optional<Member>& member) const {
        return member ? std::optional(kind.write(*member)) : std::nullopt;
    }
};

/// The values of an enumeration, each written as a word. `choices` pairs each word with its value.
template <class Enum, std::size_t count = 2>
struct Choices {
    std::array<std::pair<std::string_view, Enum>, count> choices;

    /// Returns the words of all values.
    std::array<std::string_view, count> words() const {
        std::array<std::string_view, count> all;
        for (std::size_t k = 0; k < count; ++k) {
            all[k] = choices[k].first;
        }
        return all;
    }
    std::string allowed() const { return Words{words()}.allowed(); }
    std::string schema() const { return Words{words()}.schema(); }
    bool read(const Value& value, Enum& member) const {
        const auto* word = std::get_if<std::string>(&value.data);
        for (const auto& [name, choice] : choices) {
            if (word != nullptr && *word == name) {
                member = choice;
                return true;
            }
        }
        return false;
    }
    /// Returns the word of a value. Precondition: `choices` contains the value.
    std::string_view name_of(Enum member) const {
        const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& choice) {
            return choice.second == member;
        });
        return found->first;
    }
    Value write(Enum member) const { return {std::string(name_of(member))}; }
};

}  // namespace foam::texgen
