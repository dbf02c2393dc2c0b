// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/json/json_writer.h"
#include "texgen/manifest/manifest_json.h"
#include "texgen/sheet/flipbook_json.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::fuzz {

namespace {

// Returns the images of a map in a flipbook, or nullopt if they were not all baked.
std::optional<texgen::SheetImage> image_of(const texgen::BakedSet& set,
                                           const std::string& map,
                                           std::span<const int> frames) {
    auto sequence = unless_rejected<std::invalid_argument, InputError>(
        [&] { return texgen::map_sequence(set, "out", map, frames); });
    return sequence ? std::optional(texgen::SheetImage{map + ".png", std::move(*sequence)})
                    : std::nullopt;
}

void check_json(const texgen::Json& description) {
    require(nlohmann::json::accept(texgen::indented(description)),
            "the description of a flipbook is JSON");
}

// Describes the sheets and the array textures of those maps of which all frames were baked.
void describe_images(const texgen::BakedSet& set) {
    const std::vector<int> frames = set.frames();
    std::vector<texgen::SheetImage> images;
    for (const texgen::ManifestMap& map : set.maps) {
        if (auto image = image_of(set, map.name, frames)) {
            images.push_back(std::move(*image));
        }
    }
    const texgen::SheetLayout layout{.frames = static_cast<int>(frames.size()),
                                     .frame_width = set.width,
                                     .frame_height = set.height};
    check_json(texgen::flipbook_json(set, frames, layout, images));
    for (texgen::SheetImage& image : images) {
        image.texture = texgen::ArrayTexture{"BC7_UNORM", 5};
    }
    check_json(texgen::array_json(set, frames, images));
}

// Asks for a map and a frame that a set does not have.
void ask_for_missing_images(const texgen::BakedSet& set) {
    require(!image_of(set, "/", set.frames()), "the name of a map has no '/'");
    if (!set.maps.empty()) {
        const std::vector<int> frames = {-1};
        require(!image_of(set, set.maps.front().name, frames), "no frame has the number -1");
    }
}

}  // namespace

// Parses the input as a manifest and writes the JSON files of flipbooks for each of its sets.
void fuzz_flipbook(std::string_view input) {
    const auto manifest =
        unless_rejected<InputError>([&] { return texgen::parse_manifest(input, "manifest.json"); });
    if (!manifest) {
        return;
    }
    for (const texgen::BakedSet& set : manifest->sets) {
        if (!set.frames().empty()) {
            describe_images(set);
        }
        ask_for_missing_images(set);
    }
}

}  // namespace foam::fuzz
