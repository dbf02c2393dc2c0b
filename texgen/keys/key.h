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
#include <variant>
#include <vector>

namespace foam::texgen {

/// A condition on the value of another key, such as foam.domain = "patch".
struct Condition {
    std::string_view key;  // the path of the other key
    // The values of the other key, as TOML writes them, but words without quotes: "patch", "0.0",
    // "[]". "*.exr" stands for all words with this ending.
    std::vector<std::string> values{};
    bool excludes = false;  // true if all values except `values` meet the condition

    /// Returns true if this value of the other key meets the condition.
    bool allows(std::string_view value) const;
};

/// Returns the key and the values of a condition as a text: foam.domain = "patch" or "torus". The
/// text does not depend on Condition::excludes.
std::string text_of(const Condition& condition);

/// The properties of a key that do not depend on the type of the object in which the key sets a
/// value. All string views must refer to static memory, such as string literals.
struct KeyInfo {
    std::string path;     // "foam.bubbles", or "bubbles" outside of a table
    std::string allowed;  // the allowed values: "an integer from 4 to 1000000"
    std::string schema;   // the allowed values as a JSON Schema
    /// The words that are allowed as a value, or as items of a list. Other texts may be allowed,
    /// too. This member is empty if the values are not words.
    std::vector<std::string_view> words{};
    /// Returns the specific reason why a value is not allowed; empty if there is none. An error
    /// message appends the reason to `allowed`, unless the message suggests a word. This member is
    /// empty if the kind of values has no function fault().
    std::function<std::string(const Value&)> fault{};
    std::string_view meaning;              // the meaning in one sentence
    std::string_view unit{};               // the unit, such as "pixels"; empty if there is none
    std::optional<Value> default_value{};  // nullopt if the key is unset by default
    /// The key must keep its default unless this condition is met.
    std::optional<Condition> condition{};
    /// The key has no effect unless this condition is met.
    std::optional<Condition> use{};
    /// The TOML of a preset contains the key only if this condition is met. Otherwise another key
    /// is written instead: TOML can contain either the list albedo.colors or the table with
    /// albedo.colors.from.
    std::optional<Condition> written{};
    /// The path of another key. The number of this key must be below the number of that key.
    std::optional<std::string> upper_limit{};
    /// Returns true if a value is the path of a file that the key reads. In a preset, such a path
    /// is relative to the folder of the preset's file. This member is empty if no value is a path.
    std::function<bool(const Value&)> names_file{};

    /// Returns the part of the path before the first dot; the whole path if there is no dot.
    std::string_view table() const;
    /// Returns the part of the path after the first dot; the whole path if there is no dot.
    std::string_view name() const;
};

/// A file that an object uses because the value of a key names it.
struct NamedFile {
    std::string path;
    std::string hash;  // hash of the content, 32 hexadecimal digits
};

/// Returns the entry of a key in the reference of all keys: name, default, meaning and allowed
/// values.
std::string describe(const KeyInfo& key);

/// A key of an object of type Owner. It contains everything that is needed to read, check, write
/// and document one value in the object. `read` stores a value in the object and returns true. If
/// the value is not allowed, `read` returns false and changes nothing. `write` returns the value
/// that the object holds, or nullopt if the key is unset.
template <class Owner>
struct Key : KeyInfo {
    std::function<bool(const Value&, Owner&)> read;
    std::function<std::optional<Value>(const Owner&)> write;
    /// Returns the file that the value in the object names, or nullopt if the value names none.
    /// This member is empty if no value of the key names a file.
    std::function<std::optional<NamedFile>(const Owner&)> file{};

    /// Returns true if the object holds the default of the key.
    bool is_default(const Owner& owner) const { return write(owner) == default_value; }

    /// Returns a copy of this key with the unit of its numbers, such as "pixels" or "fraction of
    /// the frames". If another key selects the unit, the text names the units and ends in "selected
    /// by PATH", where PATH is the path of that key.
    Key in(std::string_view unit_name) const {
        Key key = *this;
        key.unit = unit_name;
        return key;
    }

    /// Returns a copy of this key with a condition: the key must keep its default unless the other
    /// key has one of the given values. `other` is the complete path of the other key, because
    /// make_nested_keys does not add the name of a table to this path.
    Key only_for(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.condition = Condition{other, std::move(values)};
        return key;
    }

    /// Returns a copy of this key that has an effect only if the other key has one of the given
    /// values. `other` is a complete path, as for only_for.
    Key used_with(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.use = Condition{other, std::move(values)};
        return key;
    }
    /// Returns a copy of this key that has no effect if the other key has one of the given values.
    Key unused_with(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.use = Condition{other, std::move(values), true};
        return key;
    }

    /// Returns a copy of this key that the TOML of a preset does not always contain. The TOML
    /// contains the key only if the other key has one of the given values (written_if) or none of
    /// them (written_unless).
    Key written_if(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.written = Condition{other, std::move(values)};
        return key;
    }
    Key written_unless(std::string_view other, std::vector<std::string> values) const {
        Key key = *this;
        key.written = Condition{other, std::move(values), true};
        return key;
    }

    /// Returns a copy of this key whose text values are paths of files if `is_path` returns true
    /// for them.
    Key with_files(bool (*is_path)(std::string_view text)) const {
        Key key = *this;
        key.names_file = [is_path](const Value& value) {
            const auto* const text = std::get_if<std::string>(&value.data);
            return text != nullptr && is_path(*text);
        };
        return key;
    }

    /// Returns a copy of this key with an upper limit: the number of the key must be below the
    /// number of another key of the same owner. `other` is the path of the other key in this owner.
    Key below(std::string_view other) const {
        Key key = *this;
        key.upper_limit = other;
        return key;
    }
};

template <class Owner>
using Keys = std::vector<Key<Owner>>;

/// Returns the words that a kind of values allows; empty if the kind has no function words().
template <class ValueKind>
std::vector<std::string_view> words_of(const ValueKind& kind) {
    if constexpr (requires { kind.words(); }) {
        const auto words = kind.words();
        return {words.begin(), words.end()};
    } else {
        return {};
    }
}

/// Returns a key. `member` is a pointer to a member or another callable, which returns a reference
/// to the value in an owner. `kind` gives the allowed values; it is one of the kinds of values in
/// value_kinds.h, or has the same functions.
template <class Owner, class ValueKind, class Member>
Key<Owner> make_key(std::string_view name,
                    const ValueKind& kind,
                    std::string_view meaning,
                    const Member& member) {
    Key<Owner> key;
    key.path = name;
    key.allowed = kind.allowed();
    key.schema = kind.schema();
    key.words = words_of(kind);
    if constexpr (requires(const Value& value) { kind.fault(value); }) {
        key.fault = [=](const Value& value) { return kind.fault(value); };
    }
    key.meaning = meaning;
    key.read = [=](const Value& value, Owner& owner) {
        return kind.read(value, std::invoke(member, owner));
    };
    key.write = [=](const Owner& owner) -> std::optional<Value> {
        return kind.write(std::invoke(member, owner));
    };
    if constexpr (requires(const Owner& owner) { kind.file(std::invoke(member, owner)); }) {
        key.file = [=](const Owner& owner) { return kind.file(std::invoke(member, owner)); };
    }
    key.default_value = key.write(Owner{});
    return key;
}

/// Returns a key that reads and writes a member of Owner. `kind` is as for make_key.
template <class Owner, class Member, class ValueKind>
Key<Owner> key(std::string_view name,
               const ValueKind& kind,
               std::string_view meaning,
               Member Owner::*member) {
    return make_key<Owner>(name, kind, meaning, member);
}

/// Converts keys of an Inner object to keys of an Outer object that contains it. `part` is a
/// pointer to a member or another callable, which returns a reference to the Inner object of an
/// Outer object. The path "name" becomes "table.name". If `table` is empty, paths stay unchanged.
template <class Outer, class Inner, class Part>
Keys<Outer> make_nested_keys(std::string_view table, const Part& part, const Keys<Inner>& keys) {
    const std::string prefix = table.empty() ? "" : std::string(table) + '.';
    Keys<Outer> all;
    all.reserve(keys.size());
    for (const Key<Inner>& inner : keys) {
        Key<Outer> key{static_cast<const KeyInfo&>(inner), {}, {}, {}};
        key.path = prefix + inner.path;
        key.upper_limit =
            inner.upper_limit ? std::optional(prefix + *inner.upper_limit) : std::nullopt;
        key.read = [part, read = inner.read](const Value& value, Outer& outer) {
            return read(value, std::invoke(part, outer));
        };
        key.write = [part, write = inner.write](const Outer& outer) {
            return write(std::invoke(part, outer));
        };
        if (inner.file) {
            key.file = [part, file = inner.file](const Outer& outer) {
                return file(std::invoke(part, outer));
            };
        }
        all.push_back(std::move(key));
    }
    return all;
}

/// Converts keys of a member to keys of the object that contains it, as make_nested_keys does.
template <class Outer, class Inner>
Keys<Outer> nested_keys(std::string_view table, Inner Outer::*member, const Keys<Inner>& keys) {
    return make_nested_keys<Outer>(table, member, keys);
}

/// Returns the concatenation of lists of keys.
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
