#pragma once

#include "texgen/cli/progress.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// What the commands that run the frames of a preset are told, as it was given, not yet checked
/// against the preset's limits.
struct RunArguments {
    std::string preset;
    std::vector<std::string> sets;
    std::optional<std::string> frames;
    std::optional<std::string> size;
    std::optional<std::string> seed;
    int threads = 0;
    bool quiet = false;
    bool verbose = false;
};

/// PRESET, --set, --frames, --size, --seed; the arguments have to outlive the parsing.
void add_preset_options(CLI::App& command, RunArguments& arguments);

/// The same without PRESET and --seed.
void add_frame_options(CLI::App& command, RunArguments& arguments);

/// --threads, -q, -v.
void add_run_options(CLI::App& command, RunArguments& arguments);

/// What `--maps A,B` does, for preset_of.
Assignment maps_assignment(const std::string& maps);

/// The preset with its `--set`s, then the options that stand for a key, then `more` carried out.
/// Throws PresetError.
Preset preset_of(const RunArguments& arguments, const std::vector<Assignment>& more = {});

/// The same for a preset that was not loaded by its name.
Preset changed(Preset preset,
               const RunArguments& arguments,
               const std::vector<Assignment>& more = {});

/// Those of --frames, which may go beyond the preset's own, or all of the preset. Throws
/// std::invalid_argument.
std::vector<int> frames_of(const RunArguments& arguments, const Preset& preset);

Verbosity verbosity_of(const RunArguments& arguments);

}  // namespace foam::texgen
