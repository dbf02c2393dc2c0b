// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

/// A dependency on the value of another key, such as foam.domain = "patch".
struct Condition {
    std::string_view key;               // the path of the other key
    std::vector<std::string> values{};  // the values that it may have

    /// Returns true if the other key may have this value.
    bool allows(std::string_view value) const;
};

/// The part of a key that does not depend on the type of the object that it sets.
struct KeyInfo {
    std::string path;                          // "foam.bubbles", or "bubbles" outside of a table
    std::string allowed;                       // "an integer from 4 to 1000000"
    std::string schema;                        // the same as a JSON Schema
    std::string_view meaning;                  // in one sentence
    std::string_view unit{};                   // "pixels"; empty if there is none
    std::optional<Value> default_value{};      // nullopt if the key is unset by default
    std::optional<Condition> condition{};      // if it does not hold, the default must stay
    std::optional<std::string> upper_limit{};  // the path of a key whose number must be larger

    /// Returns the part of the path before the dot; the whole path if there is no dot.
    std::string_view table() const;
    /// Returns the part of the path after the dot; the whole path if there is no dot.
    std::string_view name() const;
};

/// Returns the entry of a key in the reference of all keys: default, meaning, and allowed values.
std::string describe(const KeyInfo& key);

/// A key of an object of type Owner: everything that is needed to read, check, write and document
/// one of its values. `read` stores a value in the object, or returns false and changes nothing if
/// the value is not allowed. `write` returns the value, or nullopt if it is unset.
template <class Owner>
struct Key : KeyInfo {
    std::function<bool(const Value&, Owner&)> read;
    std::function<std::optional<Value>(const Owner&)> write;

    bool is_default(const Owner& owner) const { return write(owner) == default_value; }

    /// Returns this key with the unit of its numbers, such as "pixels" or "fraction of the frames".
    /// If another key selects the unit, the text names the units and ends in "selected by PATH",
    /// where PATH is the path of that key.
    Key in(std::string_view unit_name) const {
        Key key = *this;
        key.unit = unit_name;
        return key;
    }

    /// Returns this key with a condition: it may differ from its default only if the other key has
    /// one of the given values.
    Key only_for(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.condition = Condition{other, std::move(values)};
        return key;
    }

    /// Returns this key with an upper limit: its number must be below the number of another key of
    /// the same owner.
    Key below(std::string_view other) const {
        Key key = *this;
        key.upper_limit = other;
        return key;
    }
};

template <class Owner>
using Keys = std::vector<Key<Owner>>;

/// Makes a key. `member`, a pointer to a member or another callable, returns a reference to the
/// value in an owner. `kind` is one of the kinds of value_kinds.h, or has the same functions.
template <class Owner, class ValueKind, class Member>
Key<Owner> key_by(std::string_view name,
                  const ValueKind& kind,
                  std::string_view meaning,
                  const Member& member) {
    Key<Owner> key;
    key.path = name;
    key.allowed = kind.allowed();
    key.schema = kind.schema();
    key.meaning = meaning;
    key.read = [=](const Value& value, Owner& owner) {
        return kind.read(value, std::invoke(member, owner));
    };
    key.write = [=](const Owner& owner) -> std::optional<Value> {
        return kind.write(std::invoke(member, owner));
    };
    key.default_value = key.write(Owner{});
    return key;
}

/// Makes a key of a member.
template <class Owner, class Member, class ValueKind>
Key<Owner> key(std::string_view name,
               const ValueKind& kind,
               std::string_view meaning,
               Member Owner::*member) {
    return key_by<Owner>(name, kind, meaning, member);
}

/// Turns keys of a part into keys of the object that contains it. `part`, a pointer to a
/// member or another callable, returns the part of an object. Each path becomes "table.name"; with
/// an empty table the paths stay unchanged.
template <class Outer, class Inner, class Part>
Keys<Outer> keys_by(std::string_view table, const Part& part, const Keys<Inner>& keys) {
    const std::string prefix = table.empty() ? "" : std::string(table) + '.';
    Keys<Outer> all;
    all.reserve(keys.size());
    for (const Key<Inner>& inner : keys) {
        Key<Outer> key{static_cast<const KeyInfo&>(inner), {}, {}};
        key.path = prefix + inner.path;
        key.upper_limit =
            inner.upper_limit ? std::optional(prefix + *inner.upper_limit) : std::nullopt;
        key.read = [part, read = inner.read](const Value& value, Outer& outer) {
            return read(value, std::invoke(part, outer));
        };
        key.write = [part, write = inner.write](const Outer& outer) {
            return write(std::invoke(part, outer));
        };
        all.push_back(std::move(key));
    }
    return all;
}

/// Turns keys of a member into keys of the object that contains it.
template <class Outer, class Inner>
Keys<Outer> keys_in(std::string_view table, Inner Outer::*member, const Keys<Inner>& keys) {
    return keys_by<Outer>(table, member, keys);
}

/// Joins lists of keys.
template <class Owner>
Keys<Owner> joined(std::initializer_list<Keys<Owner>> lists) {
    Keys<Owner> all;
    for (const Keys<Owner>& keys : lists) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

/// Returns the key with the given path, or nullptr if there is none.
template <class Owner>
const Key<Owner>* find_key(std::span<const Key<Owner>> keys, std::string_view path) {
    for (const Key<Owner>& key : keys) {
        if (key.path == path) {
            return &key;
        }
    }
    return nullptr;
}

}  // namespace foam::texgen
