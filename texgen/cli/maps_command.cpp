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
#include <span>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kNotes =
    R"(The suffix of --out, an option of bake and render, decides whether maps are written as
{}. In a PNG, maps of colors are 8-bit sRGB, with an alpha channel for a patch.
All other maps are data. Around a patch, their samples are 0, except that normals point to the
viewer, occlusion is 1 and signed distances are negative. The disks of the map event, and the outer
half of the outermost films, can extend beyond the patch.
The options of maps are keys of the preset; foamtex presets keys lists them.)";

/// Returns the map with the given name, or all maps if the name is empty. Throws
/// std::invalid_argument for an unknown name.
std::span<const Map> maps_of(const std::string& name) {
    return name.empty() ? all_maps() : std::span(&find_map(name), 1);
}

ExitCode list_maps(std::span<const Map> listed) {
    std::size_t name_width = 0;
    std::size_t unit_width = 0;
    for (const Map& map : listed) {
        name_width = std::max(name_width, map.name.size());
        unit_width = std::max(unit_width, map.unit.size());
    }
    for (const Map& map : listed) {
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

ExitCode print_maps_as_json(std::span<const Map> listed) {
    Json maps = Json::array();
    for (const Map& map : listed) {
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
    const auto name = std::make_shared<std::string>();
    CLI::Option* const map =
        command->add_option("MAP", *name, "List only this map")->option_text(" ");
    const auto markdown = std::make_shared<bool>(false);
    command->add_flag("--markdown", *markdown, "Print a table of all maps in Markdown")
        ->option_text(" ")
        ->excludes(map);
    command->footer(fmt::format(kNotes, format_names()));
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print one JSON object")->option_text(" ");
    command->callback([&action, name, markdown, json] {
        action = [name, markdown, json] {
            return *json       ? print_maps_as_json(maps_of(*name))
                   : *markdown ? print_markdown()
                               : list_maps(maps_of(*name));
        };
    });
}

}  // namespace foam::texgen
