// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/assignment.h"

#include "core/files/shown_text.h"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

namespace foam::texgen {

namespace {

// The largest number of parts of a key; "a.b" has two. toml++ and collect_node are recursive and
// need stack in proportion to the number of parts.
constexpr int kMaxKeyParts = 32;

Value value_of(const toml::node& node);

Value::List list_of(const toml::array& array) {
    Value::List list;
    for (const toml::node& item : array) {
        list.push_back(value_of(item));
    }
    return list;
}

template <class Date>
Value::Opaque opaque(const Date& date) {
    std::ostringstream text;
    text << date;
    return {text.str()};
}

Value value_of(const toml::node& node) {
    return node.visit([](const auto& typed) -> Value {
        using Node = std::remove_cvref_t<decltype(typed)>;
        if constexpr (toml::is_table<Node>) {
            return {Value::Table{}};
        } else if constexpr (toml::is_array<Node>) {
            return {list_of(typed)};
        } else if constexpr (toml::is_chronological<Node>) {
            return {opaque(typed.get())};
        } else {
            return {typed.get()};
        }
    });
}

// Returns true if TOML allows the character in a key without quotes.
bool is_bare(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

// Returns a part of a key as TOML writes it: in quotes if necessary.
std::string key_part(std::string_view key) {
    const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), is_bare);
    return bare ? std::string(key) : to_toml(Value{std::string(key)});
}

// An assignment with its position in the document, by which assignments are sorted.
struct Located {
    toml::source_position position;
    Assignment assignment;
};

// Appends the assignment of a node to `found`. If the node is a table or an array of tables, then
// appends the assignments of all nodes nested in it. An array of tables has no assignment of its
// own. `position` is the position and `path` the key of the node.
void collect_node(const toml::node& node,
                  const toml::source_position& position,
                  const std::string& path,
                  const std::string& source,
                  std::vector<Located>& found);

// Appends the assignments of all entries of a table to `found`. Their keys begin with `prefix`.
void collect(const toml::table& table,
             const std::string& prefix,
             const std::string& source,
             std::vector<Located>& found) {
    for (const auto& [key, node] : table) {
        collect_node(node, key.source().begin, prefix + key_part(key.str()), source, found);
    }
}

// Appends the assignments of all tables of an array to `found`. The key of a table contains its
// number in the array, counted from 1: event[1], event[2].
void collect_tables(const toml::array& tables,
                    const std::string& path,
                    const std::string& source,
                    std::vector<Located>& found) {
    for (std::size_t k = 0; k < tables.size(); ++k) {
        const toml::node& table = *tables.get(k);
        collect_node(
            table, table.source().begin, fmt::format("{}[{}]", path, k + 1), source, found);
    }
}

void collect_node(const toml::node& node,
                  const toml::source_position& position,
                  const std::string& path,
                  const std::string& source,
                  std::vector<Located>& found) {
    if (const toml::array* array = node.as_array();
        array != nullptr && array->is_array_of_tables()) {
        collect_tables(*array, path, source, found);
        return;
    }
    found.push_back(
        {position, {fmt::format("{}:{}", source, position.line), path, value_of(node)}});
    if (const toml::table* inner = node.as_table()) {
        collect(*inner, path + '.', source, found);
    }
}

// Returns the line of the first key of more than kMaxKeyParts parts, or nullopt if there is none.
std::optional<int> find_long_key(std::string_view toml) {
    constexpr std::string_view kSeparators = ",=[]{}\n";
    int line = 1;
    int parts = 1;
    char previous = '.';
    for (std::size_t k = 0; k < toml.size(); ++k) {
        const char c = toml[k];
        if (c == '"' || c == '\'') {
            const std::size_t end = end_of_string(toml, k);
            line += static_cast<int>(std::ranges::count(toml.substr(k, end - k), '\n'));
            k = end;
        } else if (c == '#') {
            k = std::min(toml.find('\n', k), toml.size()) - 1;
        } else if (kSeparators.find(c) != std::string_view::npos) {
            line += c == '\n' ? 1 : 0;
            parts = 1;
        } else if (c == '.' && previous != '.' && ++parts > kMaxKeyParts) {
            return line;
        }
        previous = c;
    }
    return std::nullopt;
}

toml::table parse(std::string_view toml, const std::string& source) {
    if (const auto line = find_long_key(toml)) {
        throw PresetError(fmt::format("{}:{}: malformed TOML: a key must have at most {} parts",
                                      source,
                                      *line,
                                      kMaxKeyParts));
    }
    try {
        return toml::parse(toml, source);
    } catch (const toml::parse_error& error) {
        throw PresetError(fmt::format(
            "{}:{}: malformed TOML: {}", source, error.source().begin.line, error.description()));
    }
}

}  // namespace

std::size_t end_of_string(std::string_view toml, std::size_t begin) {
    const std::size_t width = toml.substr(begin, 3) == std::string(3, toml[begin]) ? 3 : 1;
    const std::string_view quotes = toml.substr(begin, width);
    const auto is_open_end = [&](std::size_t k) {
        return k >= toml.size() || (width == 1 && toml[k] == '\n');
    };
    std::size_t k = begin + width;
    while (!is_open_end(k) && toml.substr(k, width) != quotes) {
        const bool is_escape = quotes[0] == '"' && toml[k] == '\\';
        k += is_escape && !is_open_end(k + 1) ? 2U : 1U;
    }
    if (is_open_end(k)) {
        return k - 1;
    }
    // One or two quotes before the closing three belong to the content.
    for (int extra = 0; extra < 2 && width == 3 && toml.substr(k + 1, width) == quotes; ++extra) {
        ++k;
    }
    return k + width - 1;
}

std::vector<Assignment> read_assignments(std::string_view toml, const std::string& source) {
    std::vector<Located> found;
    collect(parse(toml, source), "", source, found);
    std::stable_sort(found.begin(), found.end(), [](const Located& a, const Located& b) {
        return a.position < b.position;
    });
    std::vector<Assignment> assignments;
    assignments.reserve(found.size());
    for (Located& located : found) {
        assignments.push_back(std::move(located.assignment));
    }
    return assignments;
}

Value read_value(const std::string& text) {
    const std::string toml = "value = " + text;
    if (find_long_key(toml)) {
        return {text};
    }
    try {
        const toml::table table = toml::parse(toml);
        const bool is_value = table.size() == 1 && !table.get("value")->is_table();
        return is_value ? value_of(*table.get("value")) : Value{text};
    } catch (const toml::parse_error&) {
        return {text};
    }
}

Assignment read_set_argument(const std::string& argument) {
    const std::string location = "--set " + argument;
    if (!is_utf8(argument)) {
        throw PresetError(location + ": must be UTF-8");
    }
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw PresetError(location + ": must be KEY=VALUE, as in --set foam.bubbles=500");
    }
    return {location, argument.substr(0, equals), read_value(argument.substr(equals + 1))};
}

}  // namespace foam::texgen
