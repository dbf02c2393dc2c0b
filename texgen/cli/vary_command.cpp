// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/cli/standard_error.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/key_values.h"
#include "texgen/preset/preset_remarks.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/variations/drawn_variations.h"
#include "texgen/variations/random_variations.h"
#include "texgen/variations/sweep.h"
#include "texgen/variations/variation.h"
#include "texgen/variations/variation_files.h"
#include "texgen/variations/variation_labels.h"
#include "texgen/variations/written_variations.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kVaryExamples = R"(Examples:
  foamtex vary sea_foam --seeds 1-12
  foamtex vary lava --sweep foam.lloyd=0,1,2,4 --sweep loop.current=0..0.6:4
  foamtex vary pebbles --random 12 --set foam.bubbles=150
  foamtex vary mine.toml --sweep albedo.colormap=magma,viridis --map albedo --width 400
  foamtex bake out/lava_07.toml                bakes the seventh variation
0..0.6:4 stands for 4 evenly spaced numbers from 0 to 0.6. In a grid of two sweeps, each row has one
value of the first sweep. --seeds counts as the first sweep. --random gives every variation a random
seed and random values of the keys in preset.vary. Keys that --set sets do not vary. Every variation
becomes a preset file beside the sheet. Preset files of earlier runs are replaced or removed.)";

constexpr int kMaxVariationSide = 2048;

struct VaryArguments {
    RunArguments run;
    std::optional<std::string> seeds;
    std::vector<std::string> sweeps;
    std::optional<int> random;  // the number of random variations
    std::optional<std::uint64_t> random_seed;
    std::string map;
    VariationDrawing drawing;
    std::optional<std::filesystem::path> out;
    bool json = false;
};

std::vector<Sweep> sweeps_of(const VaryArguments& arguments) {
    std::vector<Sweep> sweeps;
    if (arguments.seeds) {
        sweeps.push_back(read_seeds(*arguments.seeds));
    }
    for (const std::string& sweep : arguments.sweeps) {
        sweeps.push_back(read_sweep(sweep));
    }
    constexpr std::size_t kMaxSweeps = 2;
    if (sweeps.empty() || sweeps.size() > kMaxSweeps) {
        throw std::invalid_argument(
            fmt::format("vary needs one or two sweeps, not {}: --seeds RANGE, --sweep KEY=VALUES; "
                        "or --random COUNT",
                        sweeps.size()));
    }
    return sweeps;
}

/// Returns the random variations of a preset. The keys that the command line sets do not vary.
std::vector<Variation> random_variations_of(const VaryArguments& arguments, const Preset& preset) {
    RandomDraw draw{.count = *arguments.random};
    draw.seed = arguments.random_seed.value_or(draw.seed);
    for (const Assignment& one : assignments_of(arguments.run)) {
        draw.fixed.insert(one.key);
    }
    return random_variations(preset, draw);
}

/// Returns the variations to draw, and the number of columns of their sheet.
VariationSet variations_of(const VaryArguments& arguments, const Preset& preset) {
    VariationSet set{.preset = arguments.run.preset,
                     .assignments = assignments_of(arguments.run),
                     .variations = {}};
    if (arguments.random) {
        set.variations = random_variations_of(arguments, preset);
        return set;
    }
    const std::vector<Sweep> sweeps = sweeps_of(arguments);
    set.variations = variations_of(sweeps);
    set.columns = sweeps.size() == 2 ? static_cast<int>(sweeps.back().values.size()) : 0;
    return set;
}

/// Prints a note for each remark (remarks_on) that holds for all variations, for example on a key
/// without effect. Leaves out the remarks in `printed`.
void print_remarks(const std::vector<Preset>& presets,
                   const std::vector<Variation>& variations,
                   const std::vector<std::string>& printed) {
    std::vector<std::string> lines = remarks_on(presets.front(), variations.front().assignments);
    std::erase_if(lines, [&](const std::string& line) {
        return std::ranges::find(printed, line) != printed.end();
    });
    for (std::size_t k = 1; k < presets.size(); ++k) {
        const std::vector<std::string> others = remarks_on(presets[k], variations[k].assignments);
        std::erase_if(lines, [&](const std::string& line) {
            return std::ranges::find(others, line) == others.end();
        });
    }
    for (const std::string& line : lines) {
        print_stderr("foamtex: note: {}", line);
    }
}

Json report_of(const WrittenVariation& written) {
    Json report = json_report(written.outcome);
    report["number"] = written.number;
    report["file"] = written.preset ? Json(written.preset->string()) : Json(nullptr);
    report["assignments"] = Json::object();
    for (const Assignment& one : written.variation.assignments) {
        report["assignments"][one.key] = to_json(one.value);
    }
    return report;
}

void print(const VaryArguments& arguments,
           const std::string& preset,
           const WrittenVariations& written) {
    if (arguments.json) {
        Json report =
            json_report(std::ranges::all_of(written.variations, [](const WrittenVariation& one) {
                return one.preset.has_value();
            }));
        report["preset"] = preset;
        report["files"] = path_list(written.files());
        report["variations"] = Json::array();
        for (const WrittenVariation& one : written.variations) {
            report["variations"].push_back(report_of(one));
        }
        print_json(report);
    } else if (!arguments.run.quiet) {
        print_files(written.files());
    }
}

/// Prints on stderr which variations have no picture. Returns the exit code.
ExitCode report_failures(const WrittenVariations& written) {
    ExitCode code = ExitCode::Success;
    for (const WrittenVariation& one : written.variations) {
        if (!one.preset) {
            print_stderr("foamtex: variation {} ({}): {}",
                         one.number,
                         label_text(one.variation),
                         failure_of(one.outcome));
            code = ExitCode::NoEquilibrium;
        }
    }
    return code;
}

std::vector<DrawnVariation> draw(const std::vector<Preset>& presets,
                                 const Preset& base,
                                 const VaryArguments& arguments) {
    VariationDrawing drawing = arguments.drawing;
    drawing.map = arguments.map.empty() ? base.image.maps.front() : arguments.map;
    drawing.threads = arguments.run.threads;
    find_map(drawing.map);
    const MemoryNeed need = memory_to_vary(presets, drawing);
    if (!arguments.run.quiet) {
        warn_of_little_memory(need);
    }
    return with_memory(need, [&] {
        ProgressReporter reporter(progress_options(arguments.run, presets.size()));
        return draw_variations(presets, drawing, reporter.callback());
    });
}

ExitCode run_vary(const VaryArguments& arguments) {
    const Preset base = preset_of(arguments.run);
    const VariationSet set = variations_of(arguments, base);
    const std::vector<Preset> presets = presets_of(base, set.variations);
    if (!arguments.run.quiet) {
        // preset_of has printed the remarks on the preset itself.
        print_remarks(presets, set.variations, remarks_on(base, set.assignments));
    }
    const std::filesystem::path folder = arguments.out.value_or("out");
    check_writable(folder);
    const VariationFiles names(folder, base.name, presets.size());
    const std::vector<std::filesystem::path> earlier = names.earlier();
    const WrittenVariations written =
        write_variations(set, draw(presets, base, arguments), names, earlier);
    print(arguments, base.name, written);
    return report_failures(written);
}

void add_random_options(CLI::App& command, VaryArguments& arguments) {
    CLI::Option* const random =
        command
            .add_option("--random",
                        arguments.random,
                        "Number of variations with random values of the keys in preset.vary")
            ->check(CLI::Range(1, kMaxValues))
            ->option_text("COUNT");
    random->excludes("--seeds")->excludes("--sweep");
    command
        .add_option("--random-seed",
                    arguments.random_seed,
                    "Seed of these random values; another seed gives other values (default: 1)")
        ->needs(random)
        ->option_text("N");
}

void add_vary_options(CLI::App& command, VaryArguments& arguments) {
    add_preset_argument(command, arguments.run);
    command.add_option("--seeds", arguments.seeds, "Seeds: 1-12, or 3,7,20-24")
        ->option_text("RANGE");
    command
        .add_option("--sweep",
                    arguments.sweeps,
                    "Values of a key: A,B,C or LOW..HIGH:COUNT; two sweeps make a grid")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUES");
    add_random_options(command, arguments);
    add_set_option(command, arguments.run);
    command.add_option("--frame", arguments.drawing.frame, "The frame to draw (default: 1)")
        ->check(CLI::Range(1, kLastFrame))
        ->option_text("N");
    command
        .add_option("--map", arguments.map, "The map to draw (default: the first of the preset)")
        ->option_text("MAP");
    command
        .add_option("--width",
                    arguments.drawing.side,
                    "Largest width and height of a picture in pixels (default: 256)")
        ->check(CLI::Range(16, kMaxVariationSide))
        ->option_text("PX");
    add_out_folder_option(
        command, arguments.out, "Folder for the sheet and the preset files (default: out)");
}

}  // namespace

void add_vary_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("vary", "Draw a preset with several seeds or values, as one sheet");
    const auto arguments = std::make_shared<VaryArguments>();
    add_vary_options(*command, *arguments);
    add_json_option(*command, arguments->json);
    add_run_options(*command, arguments->run);
    command->footer(kVaryExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_vary(*arguments); }; });
}

}  // namespace foam::texgen
