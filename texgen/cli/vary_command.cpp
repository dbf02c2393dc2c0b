// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/cli/standard_error.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_extension.h"
#include "texgen/preset/preset_remarks.h"
#include "texgen/sheet/contact_sheet.h"
#include "texgen/variations/drawn_variations.h"
#include "texgen/variations/sweep.h"
#include "texgen/variations/variation.h"
#include "texgen/variations/variation_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kVaryExamples = R"(Examples:
  foamtex vary sea_foam --seeds 1-12
  foamtex vary lava --sweep foam.lloyd=0,1,2,4 --sweep loop.current=0..0.6:4
  foamtex vary mine.toml --sweep albedo.colormap=magma,viridis --map albedo --width 400
  foamtex bake out/lava_07.toml                bakes the seventh variation
0..0.6:4 stands for 4 evenly spaced numbers from 0 to 0.6. In a grid of two sweeps, rows have the
values of the first one; --seeds is a sweep, too, and comes first. Every variation becomes a preset
file beside the sheet, which replaces the preset files of an earlier run.)";

constexpr int kLargestWidth = 2048;
constexpr int kMagnification = 2;  // of labels

struct VaryArguments {
    RunArguments run;
    std::optional<std::string> seeds;
    std::vector<std::string> sweeps;
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
    constexpr std::size_t kLargestCount = 2;
    if (sweeps.empty() || sweeps.size() > kLargestCount) {
        throw std::invalid_argument(
            fmt::format("vary needs one or two sweeps, not {}: --seeds RANGE, --sweep KEY=VALUES",
                        sweeps.size()));
    }
    return sweeps;
}

/// Returns the path of a preset as a preset file in a folder names it.
std::string base_of(const std::string& preset, const std::filesystem::path& folder) {
    if (!is_preset_path(preset)) {
        return preset;
    }
    const std::filesystem::path path = std::filesystem::absolute(preset);
    const std::filesystem::path relative = path.lexically_normal().lexically_relative(
        std::filesystem::absolute(folder).lexically_normal());
    return relative.empty() ? path.string() : relative.string();
}

void write_sheet(const std::vector<Variation>& variations,
                 const std::vector<DrawnVariation>& drawn,
                 int columns,
                 const std::filesystem::path& path) {
    std::vector<Thumbnail> thumbnails;
    for (std::size_t k = 0; k < variations.size(); ++k) {
        Thumbnail& thumbnail = thumbnails.emplace_back();
        thumbnail.pixels = drawn[k].pixels;
        thumbnail.labels = variations[k].labels;
        thumbnail.labels.front() = fmt::format("{}: {}", k + 1, thumbnail.labels.front());
    }
    const Image<std::uint8_t> sheet =
        contact_sheet(thumbnails, {.columns = columns, .magnification = kMagnification});
    write_file(
        path,
        encode_png(sheet.view(), {.color = true, .text = {}}, {.compression = Compression::Small}));
}

/// Returns the text of the preset file of a variation in a folder.
std::string preset_file(const VaryArguments& arguments,
                        const Variation& variation,
                        const std::filesystem::path& folder) {
    std::vector<Assignment> assignments = assignments_of(arguments.run);
    assignments.insert(
        assignments.end(), variation.assignments.begin(), variation.assignments.end());
    return extending_preset(base_of(arguments.run.preset, folder), assignments);
}

/// Prints on stderr which variations have no picture. Returns the exit code.
ExitCode report_failures(const std::vector<Variation>& variations,
                         const std::vector<DrawnVariation>& drawn) {
    ExitCode code = ExitCode::Success;
    for (std::size_t k = 0; k < variations.size(); ++k) {
        if (drawn[k].outcome.status != RunStatus::Complete) {
            print_stderr("foamtex: variation {} ({}): {}",
                         k + 1,
                         fmt::join(variations[k].labels, ", "),
                         failure_of(drawn[k].outcome));
            code = ExitCode::NoEquilibrium;
        }
    }
    return code;
}

/// Prints a note for each key that has no effect in any variation.
void print_remarks(const std::vector<Preset>& presets, const std::vector<Variation>& variations) {
    std::vector<std::string> lines = remarks_on(presets.front(), variations.front().assignments);
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

/// Removes the files of an earlier run that this run has not replaced.
void remove_others(const std::vector<std::filesystem::path>& earlier,
                   const std::vector<std::filesystem::path>& written) {
    for (const std::filesystem::path& file : earlier) {
        if (std::ranges::find(written, file) == written.end()) {
            std::error_code error;
            std::filesystem::remove(file, error);
        }
    }
}

void print(const VaryArguments& arguments,
           const std::string& preset,
           const std::vector<std::filesystem::path>& files) {
    if (arguments.json) {
        Json report = json_report();
        report["preset"] = preset;
        report["files"] = path_list(files);
        print_json(report);
    } else if (!arguments.run.quiet) {
        print_files(files);
    }
}

ExitCode run_vary(const VaryArguments& arguments) {
    const std::vector<Sweep> sweeps = sweeps_of(arguments);
    const std::vector<Variation> variations = variations_of(sweeps);
    const Preset base = preset_of(arguments.run);
    const std::vector<Preset> presets = presets_of(base, variations);
    VariationDrawing drawing = arguments.drawing;
    drawing.map = arguments.map.empty() ? base.image.maps.front() : arguments.map;
    drawing.threads = arguments.run.threads;
    find_map(drawing.map);
    if (!arguments.run.quiet) {
        print_remarks(presets, variations);
    }
    const std::filesystem::path folder = arguments.out.value_or("out");
    check_writable(folder);
    const VariationFiles names(folder, base.name, variations.size());
    const std::vector<std::filesystem::path> earlier = names.earlier();

    const std::vector<DrawnVariation> drawn = [&] {
        ProgressReporter reporter(progress_options(arguments.run, variations.size()));
        return draw_variations(presets, drawing, reporter.callback());
    }();
    std::vector<std::filesystem::path> files = {names.sheet()};
    const int columns = sweeps.size() == 2 ? static_cast<int>(sweeps.back().values.size()) : 0;
    make_folders(folder);
    write_sheet(variations, drawn, columns, files.front());
    for (std::size_t k = 0; k < variations.size(); ++k) {
        if (drawn[k].outcome.status == RunStatus::Complete) {
            const std::string toml = preset_file(arguments, variations[k], folder);
            files.push_back(names.preset(k + 1));
            write_variation(files.back(), toml);
        }
    }
    remove_others(earlier, files);
    print(arguments, base.name, files);
    return report_failures(variations, drawn);
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
        ->check(CLI::Range(16, kLargestWidth))
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
