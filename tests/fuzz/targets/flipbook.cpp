// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/json/json_writer.h"
#include "texgen/manifest/manifest_json.h"
#include "texgen/sheet/flipbook_json.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::fuzz {

namespace {

// Describes the sheets of those maps of which all frames were baked.
void describe_sheets(const texgen::BakedSet& set) {
    const std::vector<int> frames = set.frames();
    std::vector<texgen::SheetImage> images;
    for (const texgen::ManifestMap& map : set.maps) {
        auto sequence = unless_rejected<std::invalid_argument, InputError>(
            [&] { return texgen::map_sequence(set, "out", map.name, frames); });
        if (sequence) {
            images.push_back({map.name + ".png", std::move(*sequence)});
        }
    }
    const texgen::SheetLayout layout{.frames = static_cast<int>(frames.size()),
                                     .frame_width = set.width,
                                     .frame_height = set.height};
    const std::string json = texgen::indented(texgen::flipbook_json(set, frames, layout, images));
    require(nlohmann::json::accept(json), "the description of a flipbook is JSON");
}

}  // namespace

// Parses the input as a manifest and writes the JSON file of a flipbook for each of its sets.
void fuzz_flipbook(std::string_view input) {
    const auto manifest =
        unless_rejected<InputError>([&] { return texgen::parse_manifest(input, "manifest.json"); });
    if (!manifest) {
        return;
    }
    for (const texgen::BakedSet& set : manifest->sets) {
        if (!set.frames().empty()) {
            describe_sheets(set);
        }
    }
}

}  // namespace foam::fuzz
