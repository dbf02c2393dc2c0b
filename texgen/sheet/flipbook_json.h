// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/manifest/manifest.h"
#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <optional>
#include <span>
#include <string>

namespace foam::texgen {

/// The properties of an array texture.
struct ArrayTexture {
    std::string pixel_format;  // name of its PixelFormat
    int mip_levels = 1;
};

/// The image of a sheet or an array texture, and the frames in it.
struct SheetImage {
    std::string file;  // file name, relative to the folder of the JSON file
    MapSequence sequence;
    std::optional<ArrayTexture> texture = {};  // nullopt for a sheet
};

/// Returns a JSON description of the sheets, for programs that play them. `frames` lists the
/// numbers of the frames that a sheet contains; all sheets contain the same frames.
/// texgen/sheet/README.md describes the most important members of the JSON.
Json flipbook_json(const BakedSet& set,
                   std::span<const int> frames,
                   const SheetLayout& layout,
                   std::span<const SheetImage> images);

/// Returns a JSON description of array textures. Each frame is a layer, in the order of `frames`.
Json array_json(const BakedSet& set,
                std::span<const int> frames,
                std::span<const SheetImage> images);

}  // namespace foam::texgen
