// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_arguments.h"

#include "texgen/cli/options.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/sheet/flipbook.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace foam::texgen {

namespace {

// Returns the assignment for the values of all options --pack.
Assignment pack_assignment(const std::vector<std::string>& packings) {
    Value::List list;
    std::string location;
    for (const std::string& packing : packings) {
        location += fmt::format("{}--pack {}", location.empty() ? "" : " ", packing);
        list.push_back({packing});
    }
    return {location, "output.pack", {std::move(list)}};
}

}  // namespace

void add_image_options(CLI::App& command, ImageArguments& arguments) {
    add_maps_option(command, arguments.maps, "Maps to draw, separated by commas");
    command
        .add_option(
            "--pack", arguments.pack, "Also draw an image whose channels are maps; may be repeated")
        ->allow_extra_args(false)
        ->option_text("NAME=R,G,B[,A]");
    command
        .add_option(
            "--normal-y", arguments.normal_y, "Direction of green in normals: gl (up) or dx (down)")
        ->option_text("gl|dx");
    command
        .add_option(
            "--out",
            arguments.out,
            "Files: .png .exr .dds .ktx2 .svg .dxf .pdf .stl .glb .csv .json; {map}, {seed}, "
            "{KEY}, ####")
        ->option_text("PATTERN");
    command
        .add_option(
            "--scene", arguments.scene, "Also write the material as scene files: usda, mtlx, gltf")
        ->option_text("A,B");
    command
        .add_option("--wrap", arguments.wrap, "Bubbles at the border of a drawing: cut, or whole")
        ->option_text("cut|whole");
    command
        .add_flag(
            "--stats", arguments.stats, "Also write statistics to {preset}_stats beside the images")
        ->option_text(" ");
    command
        .add_flag("--resume",
                  arguments.resume,
                  "Keep existing frames that were made with the same settings")
        ->option_text(" ");
    command
        .add_flag("--dry-run",
                  arguments.dry_run,
                  "Estimate memory, time and the files of the frames; write nothing")
        ->option_text(" ");
    add_json_option(command, arguments.json);
}

std::vector<Assignment> assignments_of(const ImageArguments& arguments) {
    std::vector<Assignment> assignments;
    if (arguments.maps) {
        assignments.push_back(maps_assignment(*arguments.maps));
    }
    if (!arguments.pack.empty()) {
        assignments.push_back(pack_assignment(arguments.pack));
    }
    if (arguments.normal_y) {
        assignments.push_back(
            {"--normal-y " + *arguments.normal_y, "normal.y", {*arguments.normal_y}});
    }
    if (arguments.scene) {
        assignments.push_back(
            {"--scene " + *arguments.scene, "output.scene", list_value(*arguments.scene)});
    }
    if (arguments.wrap) {
        assignments.push_back({"--wrap " + *arguments.wrap, "vector.wrap", {*arguments.wrap}});
    }
    if (arguments.out) {
        assignments.push_back({"--out " + *arguments.out, "output.pattern", {*arguments.out}});
    }
    return assignments;
}

Preset with_sheets_placed(Preset preset, const RunArguments& run, const ImageArguments& arguments) {
    const bool are_set = std::ranges::any_of(
        run.sets, [](const std::string& set) { return set.starts_with("output.sheet_pattern"); });
    return arguments.out && !are_set ? with_sheets_beside_images(std::move(preset)) : preset;
}

}  // namespace foam::texgen
