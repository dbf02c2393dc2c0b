// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/progress.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The arguments of commands that simulate or draw the frames of a preset, as given on the command
/// line. Values for keys have not been checked yet.
struct RunArguments {
    std::string preset;             // positional argument: a preset, a cache, or a folder of images
    std::vector<std::string> sets;  // the values KEY=VALUE of all --set
    std::optional<std::string> profile;  // the value of --for
    std::optional<std::string> frames;   // a range in the notation of parse_frame_range
    std::optional<std::string> size;     // "W" or "WxH", pixels; or several, such as "2048,512"
    std::optional<std::string> seed;
    int threads = 0;
    bool quiet = false;
    bool verbose = false;
    std::string progress;  // the value of --progress
};

/// Adds PRESET. The arguments must outlive the parsing.
void add_preset_argument(CLI::App& command, RunArguments& arguments);

/// Adds --set. The arguments must outlive the parsing.
void add_set_option(CLI::App& command, RunArguments& arguments);

/// Adds PRESET, --set, --frames, --size and --seed. The arguments must outlive the parsing.
void add_preset_options(CLI::App& command, RunArguments& arguments);

/// Adds --set, --frames and --size. The arguments must outlive the parsing.
void add_frame_options(CLI::App& command, RunArguments& arguments);

/// Adds --threads, -q, -v and --progress. The arguments must outlive the parsing.
void add_run_options(CLI::App& command, RunArguments& arguments);

/// Returns the list ["a", "b"] for the text "a,b".
Value list_value(const std::string& words);

/// Returns the assignment that the option `--maps A,B` makes, for the argument `more` of preset_of.
/// `maps` is the text "A,B".
Assignment maps_assignment(const std::string& maps);

/// Adds --for, the profile of an engine (material/profile.h). The arguments must outlive the
/// parsing.
void add_profile_option(CLI::App& command, RunArguments& arguments);

/// Returns the assignments of every `--set`, followed by the assignments of --size and --seed,
/// which override them, because later assignments win. Throws PresetError if a `--set` is
/// malformed.
std::vector<Assignment> assignments_of(const RunArguments& arguments);

/// Returns the preset that the arguments name, after assignments in this order: those of the
/// profile, every `--set`, the other options that set a key, and `more`. Later assignments override
/// earlier ones. Throws PresetError if the preset or the profile is missing or invalid, or if a
/// value is not allowed. Also throws PresetError for a cache in place of a preset. Unless -q is
/// given, prints each remark on the preset (remarks_on) as a note on stderr. A remark can concern,
/// for example, a key that the command line, `more` or the file of the preset sets without effect.
Preset preset_of(const RunArguments& arguments, const std::vector<Assignment>& more = {});

/// Returns the given preset after the same assignments as in preset_of. Throws PresetError if the
/// profile is missing or invalid, or if a value is not allowed. Unless -q is given, prints each
/// remark (remarks_on) on the preset, the command line and `more` as a note on stderr.
Preset changed(Preset preset,
               const RunArguments& arguments,
               const std::vector<Assignment>& more = {});

/// Prints a note on stderr for each key of maps that the command line sets, although none of the
/// maps that the preset draws uses it (keys_without_maps). Prints nothing if -q is given, or if the
/// files of the preset are not images. Also prints nothing if a profile selects the maps, because
/// keys such as lit.glow influence this selection.
void note_keys_without_maps(const RunArguments& arguments, const Preset& preset);

/// Returns the frames of the option --frames, or all frames of the preset if the option is not
/// given. The option may also give frames above the last frame of the preset, whose number is
/// frames.count. Throws std::invalid_argument if the range is malformed.
std::vector<int> frames_of(const RunArguments& arguments, const Preset& preset);

/// Returns the verbosity that -q and -v select.
Verbosity verbosity_of(const RunArguments& arguments);

/// Returns the options for reporting the progress of a run. `frames` is the number of its frames.
ProgressOptions progress_options(const RunArguments& arguments, std::size_t frames);

}  // namespace foam::texgen
