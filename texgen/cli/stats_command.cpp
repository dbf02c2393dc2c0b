// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/cache.h"
#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/preset/simulation_keys.h"
#include "texgen/stats/files.h"
#include "texgen/stats/measure_run.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kStatsExamples = R"(Examples:
  foamtex stats coarsening
  foamtex stats sea_foam --frames 1-200 --seed 7 --out sea_stats
  foamtex stats my.toml --set foam.bubbles=2000
  foamtex stats foam                     a folder that foamtex simulate has written
A torus has the aspect ratio of the image; the image size in pixels does not matter.)";

struct StatsArguments {
    RunArguments run;
    std::optional<std::string> out;
    bool json = false;
};

std::filesystem::path folder_of(const StatsArguments& arguments, const Preset& preset) {
    return arguments.out ? std::filesystem::path(*arguments.out)
                         : std::filesystem::path("out") / (preset.name + "_stats");
}

Preset cached_preset(const Cache& cache, const RunArguments& arguments) {
    Preset preset = changed(cache.info().preset, arguments);
    check_same_simulation(cache.info().preset, preset);
    if (!arguments.quiet) {
        note_other_version(cache.info(), arguments.preset);
    }
    return preset;
}

ExitCode run_stats(const StatsArguments& arguments) {
    const bool has_cache = is_cache(arguments.run.preset);
    const auto cache = has_cache ? std::optional<Cache>(arguments.run.preset) : std::nullopt;
    const Preset preset = cache ? cached_preset(*cache, arguments.run) : preset_of(arguments.run);
    BakeOptions options{.frames = frames_of(arguments.run, preset),
                        .threads = arguments.run.threads};
    if (cache) {
        options.source = cache->frames_of(preset, SkippedEfforts::Counted);
        options.frames = arguments.run.frames ? options.frames : cache->info().frames;
    }
    check_writable(folder_of(arguments, preset));
    const Verbosity verbosity = verbosity_of(arguments.run);
    MemoryNeed need = memory_to_simulate(preset);
    if (cache) {
        // The message about memory must not advise lowering foam.bubbles, because a cache has a
        // fixed number of bubbles.
        need.settings_to_lower = "";
    }
    if (verbosity != Verbosity::Quiet && !cache) {
        warn_of_little_memory(need);
    }
    const MeasureSummary summary = with_memory(need, [&] {
        ProgressReporter reporter(progress_options(arguments.run, options.frames.size()));
        return measure_run(preset, options, reporter.callback());
    });
    const StatisticsFiles statistics = write_statistics(summary.run, folder_of(arguments, preset));
    if (verbosity != Verbosity::Quiet) {
        warn_of_missing_bubbles(preset, summary.outcome);
        warn_of_late_events(preset, options.frames);
    }
    if (arguments.json) {
        Json report = json_report(summary.outcome);
        report["preset"] = preset.name;
        report["frames"] = format_frame_range(options.frames);
        report["files"] = path_list(statistics.paths);
        print_json(report);
    }
    if (summary.outcome.status != RunStatus::Complete) {
        return report_failure(summary.outcome);
    }
    if (verbosity != Verbosity::Quiet && !arguments.json) {
        print_files(statistics.paths);
        note_missing_charts(statistics);
    }
    return ExitCode::Success;
}

}  // namespace

void add_stats_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("stats", "Measure the frames of a preset: tables and charts");
    const auto arguments = std::make_shared<StatsArguments>();
    add_preset_options(*command, arguments->run);
    command->get_option("PRESET")->description(
        "Name of a shipped preset, a .toml file, or a folder that foamtex simulate has written");
    command
        ->add_option("--out", arguments->out, "Folder for the files (default: out/{preset}_stats)")
        ->option_text("DIR");
    add_json_option(*command, arguments->json);
    add_run_options(*command, arguments->run);
    command->footer(kStatsExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_stats(*arguments); }; });
}

}  // namespace foam::texgen
