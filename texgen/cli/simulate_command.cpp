// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/cache.h"
#include "texgen/cli/command.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/preset/simulation_keys.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kSimulateExamples = R"(Examples:
  foamtex simulate sea_foam --cache foam
  foamtex render foam --frames 1-24 --size 2048
  foamtex render foam --frames 25-48 --size 2048      on another machine, at the same time
  foamtex stats foam
Only the foam is simulated; keys that affect only images can be changed at each render.)";

struct SimulateArguments {
    RunArguments run;
    std::string cache;
    bool json = false;
    bool force = false;
};

/// Throws std::invalid_argument if a folder contains the cache of another simulation. Throws the
/// exceptions of read_info if the cache.json in the folder is malformed.
void check_same_foam(const std::string& folder, const Preset& preset) {
    if (!is_cache(folder)) {
        return;
    }
    const CacheInfo info = read_info(folder);
    if (info.simulation == simulation_hash(preset)) {
        return;
    }
    std::string difference = fmt::format("it was simulated by foamtex {}", info.version);
    if (info.version == FOAMTEX_VERSION) {
        // The hash also depends on the content of the files that keys name. If no key differs, the
        // content of such a file does.
        difference = "the file that foam.density or foam.outline names has changed";
        try {
            check_same_simulation(info.preset, preset);
        } catch (const std::exception& error) {
            difference = error.what();
        }
    }
    throw std::invalid_argument(
        fmt::format("the cache '{}' contains a different foam of the preset {}: {}; --force "
                    "replaces this cache",
                    folder,
                    info.preset.name,
                    difference));
}

ExitCode run_simulate(const SimulateArguments& arguments) {
    const Preset preset = preset_of(arguments.run);
    const BakeOptions options{.frames = frames_of(arguments.run, preset),
                              .threads = arguments.run.threads};
    if (!arguments.force) {
        check_same_foam(arguments.cache, preset);
    }
    check_writable(arguments.cache);
    const Verbosity verbosity = verbosity_of(arguments.run);
    const MemoryNeed need = memory_to_fill_cache(preset, options.frames.size(), options.threads);
    if (verbosity != Verbosity::Quiet) {
        warn_of_full_disk(estimated_cache_size(preset, options.frames, arguments.cache),
                          arguments.cache);
        warn_of_little_memory(need);
    }
    const RunOutcome outcome = with_memory(need, [&] {
        try {
            ProgressReporter reporter(progress_options(arguments.run, options.frames.size()));
            return simulate_into_cache(preset, options, arguments.cache, reporter.callback());
        } catch (const Interrupted&) {
            print_stderr(
                "foamtex: the cache may be incomplete; to simulate the foam again from the start, "
                "run the same command");
            throw;
        }
    });
    if (verbosity != Verbosity::Quiet) {
        warn_of_missing_bubbles(preset, outcome);
        warn_of_late_events(preset, options.frames);
    }
    if (arguments.json) {
        Json report = json_report(outcome);
        report["preset"] = preset.name;
        report["frames"] = format_frame_range(options.frames);
        report["cache"] = arguments.cache;
        print_json(report);
    }
    if (outcome.status != RunStatus::Complete) {
        return report_failure(outcome);
    }
    if (verbosity != Verbosity::Quiet && !arguments.json) {
        print_stdout("{}\n", arguments.cache);
    }
    return ExitCode::Success;
}

}  // namespace

void add_simulate_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("simulate", "Simulate the foam of a preset and store its states");
    const auto arguments = std::make_shared<SimulateArguments>();
    add_preset_options(*command, arguments->run);
    command->add_option("--cache", arguments->cache, "Folder for the states")
        ->required()
        ->option_text("DIR");
    command->add_flag("--force", arguments->force, "Replace the cache of another foam")
        ->option_text(" ");
    add_json_option(*command, arguments->json);
    add_run_options(*command, arguments->run);
    command->footer(kSimulateExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_simulate(*arguments); }; });
}

}  // namespace foam::texgen
