// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace foam::texgen {

namespace {

constexpr const char* kNotes =
    R"(The suffix of --out decides whether maps are written as {}. In a PNG, colors are 8-bit sRGB,
with an alpha channel for a patch. All other maps are data; around a patch, their samples are 0,
except that normals point to the viewer, occlusion is 1 and signed distances are negative.
The options of maps are keys of the preset: foamtex presets keys)";

ExitCode list_maps() {
    std::size_t name_width = 0;
    std::size_t unit_width = 0;
    for (const Map& map : all_maps()) {
        name_width = std::max(name_width, map.name.size());
        unit_width = std::max(unit_width, map.unit.size());
    }
    for (const Map& map : all_maps()) {
        print_stdout("{:<{}}  {:<5}  {:>2} bit  {:<{}}  {}\n",
                     map.name,
                     name_width,
                     map.channels,
                     map.png_bits,
                     map.unit,
                     unit_width,
                     map.meaning);
    }
    return ExitCode::Success;
}

ExitCode print_markdown() {
    write_stdout(describe_maps_in_markdown());
    return ExitCode::Success;
}

ExitCode print_maps_as_json() {
    Json maps = Json::array();
    for (const Map& map : all_maps()) {
        maps.push_back({{"name", map.name},
                        {"meaning", map.meaning},
                        {"unit", map.unit},
                        {"channels", map.channels},
                        {"png_bits", map.png_bits}});
    }
    Json report = json_report();
    report["maps"] = maps;
    print_json(report);
    return ExitCode::Success;
}

}  // namespace

void add_maps_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "maps", "List the maps: name, channels, bits in a PNG, unit and range, meaning");
    const auto markdown = std::make_shared<bool>(false);
    command->add_flag("--markdown", *markdown, "Print a table in Markdown")->option_text(" ");
    command->footer(fmt::format(kNotes, format_names()));
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print one JSON object with all maps")->option_text(" ");
    command->callback([&action, markdown, json] {
        action = *json ? print_maps_as_json : *markdown ? print_markdown : list_maps;
    });
}

}  // namespace foam::texgen
