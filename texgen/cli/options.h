// SPDX-License-Identifier: Apache-2.0

#pragma once

// Options that several commands share. Each function add_NAME_option adds one option to a command.
// The variable that receives the value must exist until the command line has been parsed.

#include "texgen/cli/progress.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
class Option;
}  // namespace CLI

namespace foam::texgen {

/// Splits a list of words at its commas. Spaces around the words are dropped.
std::vector<std::string> split_words(const std::string& list);

/// Allows only the given words as values of an option, and shows them in the help. The error
/// message for any other value lists the words and suggests the most similar one, if any is
/// similar.
void allow_only(CLI::Option& option, const std::vector<std::string>& words);

/// Adds --json, with which the command prints one JSON object (json_report.h).
void add_json_option(CLI::App& command, bool& json);

/// Adds -q, --quiet, and returns the option. `meaning` is the text of the option in the help.
CLI::Option* add_quiet_option(CLI::App& command,
                              bool& quiet,
                              const char* meaning = "Print only errors");

/// Adds --progress, the form of the progress on stderr: "auto" or "json". Returns the option.
CLI::Option* add_progress_option(CLI::App& command, std::string& progress);

/// Returns the progress options of a command that has no option -v, such as `verify`. `progress` is
/// the value of --progress.
ProgressOptions progress_options(bool quiet, const std::string& progress);

/// Adds --threads, the number of threads. 0, the default, uses all hardware threads.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --frames, a range in the notation of parse_frame_range. `meaning` is the first part of the
/// text of the option in the help; examples of ranges follow it.
void add_frames_option(CLI::App& command,
                       std::optional<std::string>& frames,
                       const std::string& meaning = "Frames");

/// Adds --maps, the names of maps, separated by commas. `meaning` is the text of the option in the
/// help.
void add_maps_option(CLI::App& command, std::optional<std::string>& maps, const char* meaning);

/// Adds --preset, the name of the preset whose images are used if a folder has images of several
/// presets (image_folder.h).
void add_preset_name_option(CLI::App& command, std::string& preset);

/// Adds -o, --out, the output folder. `meaning` is the text of the option in the help.
void add_out_folder_option(CLI::App& command,
                           std::optional<std::filesystem::path>& out,
                           const char* meaning);

}  // namespace foam::texgen
