#include "texgen/bake/written_file.h"

#include <string_view>

namespace foam::texgen {

namespace {

constexpr int kWithOpacity = 4;

std::string_view kind_of(const MapImage& image) {
    constexpr std::array<std::string_view, 3> kKinds = {"color", "number", "id"};
    return kKinds.at(image.index());
}

/// Colours of a patch have an opacity as well.
bool has_opacity(const MapImage& image) {
    const auto* colors = std::get_if<ColorPixels>(&image);
    return colors != nullptr && colors->pixels.channels() == kWithOpacity;
}

bool is_color(const MapImage& image) {
    return std::holds_alternative<ColorPixels>(image);
}

MapSamples common_samples(const Map& map, const MapImage& image) {
    MapSamples samples;
    samples.kind = kind_of(image);
    samples.channels = std::string(map.channels) + (has_opacity(image) ? " A" : "");
    samples.color_space = "data";
    samples.alpha = "none";
    if (const auto* numbers = std::get_if<NumberPixels>(&image)) {
        samples.range = {numbers->low, numbers->high};
    }
    return samples;
}

std::string_view type_of(const MapImage& image, ExrType numbers) {
    if (is_color(image)) {
        return "half";
    }
    if (std::holds_alternative<IdPixels>(image)) {
        return "uint32";
    }
    return numbers == ExrType::Half ? "half" : "float";
}

}  // namespace

MapSamples samples_in_png(const Map& map, const MapImage& image, int bits) {
    MapSamples samples = common_samples(map, image);
    samples.type = bits == 8 || is_color(image) ? "uint8" : "uint16";
    if (is_color(image)) {
        samples.color_space = "sRGB";
        samples.alpha = has_opacity(image) ? "straight" : "none";
    }
    if (const auto* numbers = std::get_if<NumberPixels>(&image)) {
        samples.channels += numbers->pixels.channels() == 2 ? " 0" : "";
    }
    return samples;
}

MapSamples samples_in_exr(const Map& map, const MapImage& image, ExrType numbers) {
    MapSamples samples = common_samples(map, image);
    samples.type = type_of(image, numbers);
    if (is_color(image)) {
        samples.color_space = "linear sRGB";
        samples.alpha = has_opacity(image) ? "premultiplied" : "none";
    }
    return samples;
}

}  // namespace foam::texgen
