// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/job_file.h"

#include "texgen/image/shell_word.h"
#include "texgen/keys/nearest.h"
#include "texgen/preset/assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::string_view kPreset = "preset";

/// The values that a key of a job takes. Each key except `preset` stands for the option of `bake`
/// with the same name. A key of the kind `One` takes a text or a number, a key of the kind `Flag`
/// takes true or false. Keys of the other kinds take a text, a number or a list. For `Words`, the
/// elements of the list are joined with commas; for `Repeated`, the option is given once for each
/// element.
enum class Takes { One, Words, Repeated, Flag };

struct JobKey {
    std::string_view name;
    Takes takes;
};

constexpr std::array kJobKeys = {JobKey{kPreset, Takes::One},
                                 JobKey{"set", Takes::Repeated},
                                 JobKey{"frames", Takes::One},
                                 JobKey{"size", Takes::One},
                                 JobKey{"seed", Takes::One},
                                 JobKey{"for", Takes::One},
                                 JobKey{"maps", Takes::Words},
                                 JobKey{"pack", Takes::Repeated},
                                 JobKey{"normal-y", Takes::One},
                                 JobKey{"out", Takes::One},
                                 JobKey{"scene", Takes::Words},
                                 JobKey{"wrap", Takes::One},
                                 JobKey{"stats", Takes::Flag},
                                 JobKey{"threads", Takes::One}};

/// The parts of "bake[2].size": the number of the job, from 1, and the name of the key.
struct JobPath {
    std::size_t job = 0;
    std::string_view name;
};

std::optional<JobPath> parse_path(std::string_view path) {
    constexpr std::string_view kStart = "bake[";
    if (!path.starts_with(kStart)) {
        return std::nullopt;
    }
    JobPath parsed;
    const char* const first = path.data() + kStart.size();
    const auto [end, error] = std::from_chars(first, path.data() + path.size(), parsed.job);
    const std::string_view rest(end, static_cast<std::size_t>(path.data() + path.size() - end));
    if (error != std::errc() || !rest.starts_with(']')) {
        return std::nullopt;
    }
    parsed.name = rest.substr(std::min<std::size_t>(2, rest.size()));
    return parsed;
}

[[noreturn]] void reject(const Assignment& assignment, const std::string& reason) {
    throw PresetError(fmt::format("{}: key '{}' {}", assignment.location, assignment.key, reason));
}

const JobKey& find_key(const Assignment& assignment, std::string_view name) {
    const auto* const found = std::ranges::find(kJobKeys, name, &JobKey::name);
    if (found == kJobKeys.end()) {
        std::array<std::string_view, kJobKeys.size()> names;
        std::ranges::transform(kJobKeys, names.begin(), &JobKey::name);
        reject(assignment,
               fmt::format("is unknown; a job has the keys {}{}",
                           fmt::join(names, ", "),
                           did_you_mean(name, names)));
    }
    return *found;
}

/// Returns the text that a value has on a command line.
std::string text_of(const Value& value, const Assignment& assignment) {
    if (const auto* const text = std::get_if<std::string>(&value.data)) {
        return *text;
    }
    const bool is_number = std::holds_alternative<std::int64_t>(value.data) ||
                           std::holds_alternative<double>(value.data);
    if (!is_number) {
        reject(assignment, fmt::format("= {}: must be a text or a number", to_toml(value)));
    }
    return to_toml(value);
}

void add(const Assignment& assignment, const JobKey& key, std::vector<std::string>& arguments) {
    const std::string option = fmt::format("--{}", key.name);
    const auto* const list = std::get_if<Value::List>(&assignment.value.data);
    if (key.takes == Takes::Flag) {
        const auto* const is_set = std::get_if<bool>(&assignment.value.data);
        if (is_set == nullptr) {
            reject(assignment,
                   fmt::format("= {}: must be true or false", to_toml(assignment.value)));
        }
        if (*is_set) {
            arguments.push_back(option);
        }
    } else if (list == nullptr || key.takes == Takes::One) {
        arguments.insert(arguments.end(), {option, text_of(assignment.value, assignment)});
    } else if (key.takes == Takes::Repeated) {
        for (const Value& value : *list) {
            arguments.insert(arguments.end(), {option, text_of(value, assignment)});
        }
    } else {
        std::string words;
        for (const Value& value : *list) {
            words += (words.empty() ? "" : ",") + text_of(value, assignment);
        }
        arguments.insert(arguments.end(), {option, words});
    }
}

}  // namespace

std::string Job::command() const {
    std::string command = "foamtex";
    for (const std::string& argument : arguments) {
        command += " " + shell_word(argument);
    }
    return command;
}

std::vector<Job> read_jobs(std::string_view toml, const std::string& source) {
    std::vector<Job> jobs;
    for (const Assignment& assignment : read_assignments(toml, source)) {
        const std::optional<JobPath> path = parse_path(assignment.key);
        if (!path) {
            reject(assignment, "is unknown; a job file has tables [[bake]]");
        }
        jobs.resize(std::max(jobs.size(), path->job), {{"bake", ""}});
        if (path->name.empty()) {
            continue;  // the assignment is not of a key, but of the whole table [[bake]]
        }
        const JobKey& key = find_key(assignment, path->name);
        std::vector<std::string>& arguments = jobs[path->job - 1].arguments;
        if (key.name == kPreset) {
            arguments[1] = text_of(assignment.value, assignment);
        } else {
            add(assignment, key, arguments);
        }
    }
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        if (jobs[k].arguments[1].empty()) {
            throw PresetError(fmt::format("{}: bake[{}] has no preset", source, k + 1));
        }
    }
    if (jobs.empty()) {
        throw PresetError(fmt::format("{}: has no table [[bake]]", source));
    }
    return jobs;
}

}  // namespace foam::texgen
