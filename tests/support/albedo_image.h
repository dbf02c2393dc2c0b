// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/maps/quantize.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace foam::test {

/// Draws the map `albedo` of a frame and encodes it as 8-bit sRGB. The image has three channels;
/// the image of a patch has a fourth, the opacity. Throws as texgen::draw_albedo does.
inline texgen::Image<std::uint8_t> albedo_image(const Frame& frame,
                                                const texgen::RasterGrid& grid,
                                                const texgen::AlbedoOptions& albedo,
                                                int threads) {
    const texgen::FoamRecord record;
    texgen::MapOptions options;
    options.albedo = albedo;
    const std::vector<std::string> names{"albedo"};
    const texgen::DistanceNeeds distance = texgen::distance_needs(names, options);
    texgen::ShownLayers shown{{{frame, record, nullptr, distance}, grid, threads}};
    const texgen::MapImage image = texgen::draw(texgen::find_map("albedo"), shown, options);
    return texgen::srgb_codes(std::get<texgen::ColorPixels>(image));
}

}  // namespace foam::test
