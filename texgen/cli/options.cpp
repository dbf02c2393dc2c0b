// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/options.h"

#include "core/parallel/parallel_for.h"
#include "texgen/keys/nearest.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr const char* kJsonProgress = "json";
constexpr const char* kRangeExamples =
    ": 5, 1-10, 1-10x2 (every second), 1-10y3 (all but every third) or 1-3,7";

}  // namespace

std::vector<std::string> split_words(const std::string& list) {
    std::vector<std::string> words = CLI::detail::split(list, ',');
    for (std::string& word : words) {
        CLI::detail::trim(word);
    }
    return words;
}

void allow_only(CLI::Option& option, const std::vector<std::string>& words) {
    option.option_text(fmt::format("{}", fmt::join(words, "|")));
    option.check([words](const std::string& value) {
        const std::vector<std::string_view> candidates(words.begin(), words.end());
        return std::ranges::find(words, value) != words.end()
                   ? ""
                   : fmt::format("'{}' must be one of {}{}",
                                 value,
                                 fmt::join(words, ", "),
                                 did_you_mean(value, candidates));
    });
}

void add_json_option(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Print the results as one JSON object")->option_text(" ");
}

CLI::Option* add_quiet_option(CLI::App& command, bool& quiet, const char* meaning) {
    return command.add_flag("-q,--quiet", quiet, meaning)->option_text(" ");
}

CLI::Option* add_progress_option(CLI::App& command, std::string& progress) {
    CLI::Option* const option = command.add_option(
        "--progress", progress, "Progress on stderr: a bar, or one JSON line per second");
    allow_only(*option, {"auto", kJsonProgress});
    return option;
}

ProgressOptions progress_options(bool quiet, const std::string& progress) {
    return {.verbosity = quiet ? Verbosity::Quiet : Verbosity::Normal,
            .json = progress == kJsonProgress};
}

void add_threads_option(CLI::App& command, int& threads) {
    command
        .add_option(
            "--threads", threads, "Number of threads; 0, the default, uses all hardware threads")
        ->check(CLI::Range(0, kMaxThreads))
        ->option_text("N");
}

void add_frames_option(CLI::App& command,
                       std::optional<std::string>& frames,
                       const std::string& meaning) {
    command.add_option("--frames", frames, meaning + kRangeExamples)->option_text("RANGE");
}

void add_maps_option(CLI::App& command, std::optional<std::string>& maps, const char* meaning) {
    command.add_option("--maps", maps, meaning)->option_text("A,B");
}

void add_preset_name_option(CLI::App& command, std::string& preset) {
    command
        .add_option(
            "--preset", preset, "Preset of the images, if the folder has images of several presets")
        ->option_text("NAME");
}

void add_out_folder_option(CLI::App& command,
                           std::optional<std::filesystem::path>& out,
                           const char* meaning) {
    command.add_option("-o,--out", out, meaning)->option_text("FOLDER");
}

}  // namespace foam::texgen
