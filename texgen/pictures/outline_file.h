// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/pictures/traced_outlines.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The outline in a file.
struct FileOutline {
    std::vector<foam::Outline> parts;  // one per connected part, the largest first; y points up
    std::string hash;  // pixel_hash of a picture, or text_hash of an SVG (pixel_hash.h)
};

/// Returns true if the text is the name of a file that contains an outline. Such a name ends in
/// ".svg" or in the suffix of an image format.
bool is_outline_name(std::string_view text);

/// Returns the outline in a file: the filled shapes of an SVG (read_svg_shapes), or the silhouette
/// of a picture (silhouette.h). Overlapping shapes are united. Throws InputError, whose message
/// names the file, if the file cannot be read or contains no shape, and OutOfMemory if the machine
/// has too little memory.
FileOutline read_outline_file(const std::string& path);

/// Returns the outline in the document of an SVG: one element per connected part, the largest
/// first, with y pointing up. The shapes are drawn as a picture of about `grid_points` pixels,
/// whose outline is traced. The unit of the result is a pixel of this picture. Throws InputError as
/// read_svg_shapes does. Also throws InputError if there is no filled shape, if coordinates are too
/// large, or if there are too many long lines and curves. The message does not name the file.
std::vector<foam::Outline> outlines_of_svg(std::string_view document,
                                           double grid_points = kOutlineGridPoints);

}  // namespace foam::texgen
