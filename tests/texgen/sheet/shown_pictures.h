// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/temporary_folder.h"
#include "texgen/image/png.h"
#include "texgen/sheet/display_frame.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Returns the entry of a manifest for a map with this color space and this kind of opacity.
inline ManifestMap map_of(const char* color_space, const char* alpha = "none") {
    ManifestMap map;
    map.samples = MapSamples{};
    map.samples->color_space = color_space;
    map.samples->alpha = alpha;
    return map;
}

/// Writes samples to a PNG. Returns the frame as a preview shows it.
template <class Sample>
DisplayFrame shown(const Image<Sample>& image,
                   const char* color_space,
                   const char* alpha = "none") {
    const TemporaryFolder folder;
    write_png(folder.path() / "a.png", image.view());
    return read_display_frame({.path = folder.path() / "a.png"}, map_of(color_space, alpha));
}

/// Returns an image of these codes, pixel by pixel.
inline Image<std::uint8_t> picture(int width,
                                   int height,
                                   int channels,
                                   std::vector<std::uint8_t> codes) {
    Image<std::uint8_t> image(width, height, channels);
    std::ranges::copy(codes, image.samples().begin());
    return image;
}

/// Returns the codes that the frame is shown with.
inline std::vector<std::uint8_t> codes(const DisplayFrame& frame) {
    const Image<std::uint8_t> image = codes_of(frame);
    return {image.samples().begin(), image.samples().end()};
}

}  // namespace foam::texgen
