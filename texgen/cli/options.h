// SPDX-License-Identifier: Apache-2.0

#pragma once

// Options that several commands share. Each function adds one option to a command. The variable
// for the value must outlive the parsing.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
class Option;
}  // namespace CLI

namespace foam::texgen {

/// Adds --json: the command prints one JSON object (json_report.h).
void add_json_option(CLI::App& command, bool& json);

/// Adds -q, --quiet. `meaning` is the text of the option in the help.
CLI::Option* add_quiet_option(CLI::App& command,
                              bool& quiet,
                              const char* meaning = "Print only errors");

/// Adds --threads, where 0 means one per hardware thread.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --frames, a range in the notation of parse_frame_range.
void add_frames_option(CLI::App& command,
                       std::optional<std::string>& frames,
                       const char* meaning = "Frames, such as 5, 1-10, 1-10x2, 1-10y3 or 1-3,7");

/// Adds --maps, names separated by commas.
void add_maps_option(CLI::App& command, std::optional<std::string>& maps, const char* meaning);

/// Adds --preset. choose_set selects the set of images of this preset.
void add_set_option(CLI::App& command, std::string& preset);

/// Adds -o, --out: the output folder.
void add_out_folder_option(CLI::App& command,
                           std::optional<std::filesystem::path>& out,
                           const char* meaning);

}  // namespace foam::texgen
