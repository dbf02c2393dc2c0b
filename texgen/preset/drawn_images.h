// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/drawn_image.h"
#include "texgen/preset/preset.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns the images that are drawn for every frame of a preset: the maps of image.maps, then the
/// packings of output.pack.
std::vector<DrawnImage> drawn_images(const Preset& preset);

/// Returns the maps from which the images of a preset (drawn_images) are made, each once.
std::vector<const Map*> source_maps(const Preset& preset);

/// Returns true if drawing one of the source_maps also needs the frame after the drawn one.
bool needs_next_frame(const Preset& preset);

/// Returns the names of the source_maps.
std::vector<std::string> source_map_names(const Preset& preset);

/// Returns the word that takes the place of {map} in the file names of an image. This is the word
/// that output.names gives, or else the name of the image.
std::string file_word(const Preset& preset, std::string_view image);

/// Throws std::invalid_argument if two images of a preset have the same word in their file names,
/// for example two packings of the same name.
void check_file_words(const Preset& preset);

}  // namespace foam::texgen
