// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/written_file.h"

#include "texgen/image/primaries.h"
#include "texgen/maps/number_channels.h"

#include <algorithm>
#include <string_view>

namespace foam::texgen {

namespace {

std::string_view kind_of(const MapImage& image) {
    constexpr std::array<std::string_view, 3> kKinds = {"color", "number", "id"};
    return kKinds.at(image.index());
}

/// Returns true for colors with an opacity channel, as in images of a patch.
bool has_opacity(const MapImage& image) {
    const auto* colors = std::get_if<ColorPixels>(&image);
    return colors != nullptr && colors->pixels.channels() == kChannelsWithOpacity;
}

bool is_color(const MapImage& image) {
    return std::holds_alternative<ColorPixels>(image);
}

MapSamples common_samples(const DrawnImage& drawn, const MapImage& image) {
    MapSamples samples;
    samples.kind = kind_of(image);
    samples.channels = std::string(drawn.traits().channels) +
                       (has_opacity(image) && !drawn.packs_colors() ? " A" : "");
    samples.color_space = "data";
    samples.alpha = "none";
    if (const auto* numbers = std::get_if<NumberPixels>(&image)) {
        samples.range = {numbers->low, numbers->high};
    }
    return samples;
}

void describe_codes(const MapImage& image, int bits, MapSamples& samples) {
    const bool fits_bytes = bits == 8 || is_color(image);
    samples.type = name_of(fits_bytes ? SampleType::Uint8 : SampleType::Uint16);
    if (is_color(image)) {
        samples.color_space = "sRGB";
        samples.alpha = has_opacity(image) ? "straight" : "none";
    }
    if (const auto* numbers = std::get_if<NumberPixels>(&image)) {
        samples.channels += numbers->pixels.channels() == 2 ? " 0" : "";
    }
}

void describe_numbers(const MapImage& image, const OutputOptions& output, MapSamples& samples) {
    samples.type = name_of(number_type(image, output.exr_numbers));
    if (is_color(image)) {
        samples.color_space = linear_space_name(output.primaries);
        samples.alpha = has_opacity(image) ? "premultiplied" : "none";
    }
}

}  // namespace

int code_bits(const DrawnImage& image, const ImageFormat& format) {
    return std::min(image.traits().png_bits, format.code_bits);
}

MapSamples describe_samples(const DrawnImage& image,
                            const MapImage& pixels,
                            const ImageFormat& format,
                            const OutputOptions& output) {
    MapSamples samples = common_samples(image, pixels);
    if (format.samples == FormatSamples::Codes) {
        describe_codes(pixels, code_bits(image, format), samples);
    } else {
        describe_numbers(pixels, output, samples);
    }
    if (image.packs_colors()) {
        // In a packing of colors, the channel A shows a map of its own; it is not the alpha of the
        // colors.
        samples.alpha = "none";
    }
    return samples;
}

}  // namespace foam::texgen
