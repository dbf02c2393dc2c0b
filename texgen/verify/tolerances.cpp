// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/tolerances.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/keys/nearest.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/rejection.h"
#include "texgen/verify/limit_keys.h"
#include "texgen/verify/normal_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::string_view kDefaultTable = "default";

// Returns the end of a message about an unknown word: the most similar candidate, or all of them.
std::string hint(std::string_view word, const std::vector<std::string_view>& candidates) {
    const std::string_view meant = nearest(word, candidates);
    return meant.empty() ? fmt::format("must be one of {}", fmt::join(candidates, ", "))
                         : fmt::format("did you mean '{}'?", meant);
}

std::vector<std::string_view> table_names() {
    const std::span<const std::string_view> maps = map_names();
    std::vector<std::string_view> names(maps.begin(), maps.end());
    names.push_back(kDefaultTable);
    return names;
}

std::vector<std::string_view> key_names() {
    std::vector<std::string_view> names;
    for (const KeyInfo& key : limit_keys()) {
        names.push_back(key.path);
    }
    return names;
}

// Reads the assignments (keys with values) of a file of tolerances.
class ToleranceReader {
  public:
    void read(const Assignment& assignment) {
        const std::size_t dot = assignment.key.find('.');
        if (dot == std::string::npos) {
            add_table(assignment);
        } else {
            assign(assignment, assignment.key.substr(0, dot), assignment.key.substr(dot + 1));
        }
    }

    Tolerances finish() {
        for (auto& [name, limits] : tables_) {
            if (!tables_with_warnings_.contains(name)) {
                limits.warn.sample = std::numeric_limits<double>::infinity();
            }
        }
        return Tolerances(std::move(tables_));
    }

  private:
    void add_table(const Assignment& assignment) {
        const std::vector<std::string_view> names = table_names();
        if (!std::holds_alternative<Value::Table>(assignment.value.data)) {
            reject(assignment,
                   "must be in a table: [default], or the name of a map such as [normal]");
        }
        if (std::ranges::find(names, assignment.key) == names.end()) {
            reject(assignment, "unknown table; " + hint(assignment.key, names));
        }
        tables_[assignment.key];
    }

    void assign(const Assignment& assignment, const std::string& table, const std::string& name) {
        const Key<CompareLimits>* const key = find_key(std::span(limit_keys()), name);
        if (key == nullptr) {
            reject(assignment, "unknown key; " + hint(name, key_names()));
        }
        if (is_angle_key(*key) && table != kDefaultTable && !is_normal_map(table)) {
            reject(assignment,
                   fmt::format("only the tables of normal maps ({}) and [default] have limits of "
                               "angles",
                               fmt::join(normal_map_names(), ", ")));
        }
        if (!key->read(assignment.value, tables_[table])) {
            reject_value(assignment, *key);
        }
        if (is_warning_key(*key)) {
            tables_with_warnings_.insert(table);
        }
    }

    std::map<std::string, CompareLimits, std::less<>> tables_;
    std::set<std::string> tables_with_warnings_;
};

}  // namespace

CompareLimits Tolerances::limits_of(std::string_view map) const {
    for (const std::string_view name : {map, kDefaultTable}) {
        const auto found = tables_.find(name);
        if (found != tables_.end()) {
            return found->second;
        }
    }
    return {};
}

Tolerances parse_tolerances(std::string_view toml, const std::string& source) {
    ToleranceReader reader;
    for (const Assignment& assignment : read_assignments(toml, source)) {
        reader.read(assignment);
    }
    return reader.finish();
}

Tolerances read_tolerances(const std::filesystem::path& path) {
    try {
        const Bytes content = read_file(path, kPresetInput);
        return parse_tolerances(as_text(content), path.string());
    } catch (const InputError& error) {
        throw PresetError(error.what());
    }
}

}  // namespace foam::texgen
