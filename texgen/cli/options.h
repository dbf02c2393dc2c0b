#pragma once

// Options that several commands have. Each function adds one option to a command; the value has to
// outlive the parsing.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
class Option;
}  // namespace CLI

namespace foam::texgen {

/// --json: the command prints one JSON object (JsonReport).
void add_json_option(CLI::App& command, bool& json);

/// -q, --quiet. `meaning` is the line of the help.
CLI::Option* add_quiet_option(CLI::App& command,
                              bool& quiet,
                              const char* meaning = "Say nothing but errors");

/// --threads, 0 for one per hardware thread.
void add_threads_option(CLI::App& command, int& threads);

/// --frames, a range as parse_frame_range reads it.
void add_frames_option(CLI::App& command,
                       std::optional<std::string>& frames,
                       const char* meaning = "As 5, 1-10, 1-10x2, 1-10y3 or 1-3,7");

/// --maps, names with commas between them.
void add_maps_option(CLI::App& command, std::optional<std::string>& maps, const char* meaning);

/// --preset, for choose_set.
void add_set_option(CLI::App& command, std::string& preset);

/// -o, --out: the folder of the output.
void add_out_folder_option(CLI::App& command,
                           std::optional<std::filesystem::path>& out,
                           const char* meaning);

}  // namespace foam::texgen
