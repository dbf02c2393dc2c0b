// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/api/state.h"
#include "texgen/image/image.h"

#include <string>

namespace foam::texgen {

/// Returns the shape of the images that the functions below return. `integers` is true for
/// code_image, false for number_image. An image that code_image returns for a map with two
/// channels, such as motion, has three channels. Throws std::invalid_argument for an unknown map.
foamtex::ImageShape shape_of(const foamtex::Frame::State& frame,
                             const std::string& map_name,
                             bool integers);

/// Draws a map of a frame. Numbers are in the unit of the map; colors are linear light, multiplied
/// by the opacity if there is one. `threads` is from 0 to kMaxThreads; 0 stands for all hardware
/// threads. Throws std::invalid_argument for an unknown map, and if the map needs the next frame
/// but `frame` was simulated without it. Throws foamtex::ArgumentError if `threads` is out of
/// range.
Image<float> number_image(const foamtex::Frame::State& frame,
                          const std::string& map_name,
                          int threads);

/// Draws a map of a frame as codes: integers, as in a PNG (quantize). Sample is std::uint8_t or
/// std::uint16_t. Throws as number_image does; also throws std::invalid_argument if a range of the
/// map is automatic and has not been fitted, or for 16-bit codes of colors.
template <class Sample>
Image<Sample> code_image(const foamtex::Frame::State& frame,
                         const std::string& map_name,
                         int threads);

}  // namespace foam::texgen
