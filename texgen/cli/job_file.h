// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// One job of a job file: the command line of a bake.
struct Job {
    std::vector<std::string> arguments;  // "bake", the preset, options

    /// Returns the command in the notation of a shell.
    std::string command() const;
};

/// Reads a job file: a TOML document with a table [[bake]] for each job. `source` is the name of
/// the document in messages.
///
/// The key `preset` names the preset. Every other key is an option of `bake` without its leading
/// dashes, such as `size` or `normal-y` (kJobKeys in job_file.cpp lists them). The value may be a
/// list if the key is `set` or `pack`, because these options may be repeated. It may also be a list
/// if the key is `maps` or `scene`, because these options take several words. The value of the flag
/// `stats` is true or false.
///
/// Throws PresetError if the document is malformed or has no job. Also throws it if a job has no
/// preset, or has an unknown key or a value of the wrong type. All other checks of values are made
/// when a job runs.
std::vector<Job> read_jobs(std::string_view toml, const std::string& source);

}  // namespace foam::texgen
