// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A bake of a job file, as the command line that runs it.
struct Job {
    std::vector<std::string> arguments;  // "bake", the preset, options

    /// Returns the command in the notation of a shell.
    std::string command() const;
};

/// Reads a job file: a TOML document with a table [[bake]] for each job. The key `preset` is the
/// preset; every other key is an option of `bake` without its dashes, such as `size`, `set` or
/// `normal-y`. An option that may be repeated takes a list, and one whose words are separated by
/// commas takes a list, too. A flag, such as `stats`, takes true or false. `source` is the name of
/// the document in messages. Throws PresetError if the document is malformed, has no job, or has a
/// key that is none of these. Values are checked when a job runs.
std::vector<Job> read_jobs(std::string_view toml, const std::string& source);

}  // namespace foam::texgen
