#include "texgen/maps/exr_layers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

constexpr int kWithOpacity = 4;

/// The first word, or nothing.
std::string_view take_word(std::string_view& words) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    return word;
}

std::variant<Image<float>, Image<std::uint32_t>> pixels_of(MapImage map) {
    if (const auto* colors = std::get_if<ColorPixels>(&map)) {
        return premultiplied(*colors);
    }
    if (auto* numbers = std::get_if<NumberPixels>(&map)) {
        return std::move(numbers->pixels);
    }
    return std::move(std::get<IdPixels>(map).pixels);
}

}  // namespace

void ExrLayers::add(std::string_view layer, std::string_view names, MapImage map) {
    const ExrType type = type_of(map);
    has_colors_ = has_colors_ || std::holds_alternative<ColorPixels>(map);
    const Pixels& pixels = pixels_.emplace_back(pixels_of(std::move(map)));
    const std::string prefix = layer.empty() ? std::string() : std::string(layer) + '.';
    const int count = std::visit([](const auto& image) { return image.channels(); }, pixels);
    for (int k = 0; k < count; ++k) {
        const std::string_view word = take_word(names);
        const std::string name = prefix + (word.empty() ? "A" : std::string(word));
        std::visit(
            [&](const auto& image) {
                channels_.push_back({name, type, image.view(), k});
            },
            pixels);
    }
}

ExrType ExrLayers::type_of(const MapImage& map) const {
    if (std::holds_alternative<ColorPixels>(map)) {
        return ExrType::Half;
    }
    return std::holds_alternative<IdPixels>(map) ? ExrType::Uint : numbers_;
}

Image<float> premultiplied(const ColorPixels& colors) {
    const Image<std::uint16_t>& from = colors.pixels;
    Image<float> light(from.width(), from.height(), from.channels());
    std::ranges::transform(from.samples(), light.samples().begin(), [](std::uint16_t value) {
        return static_cast<float>(value) / static_cast<float>(kWhite);
    });
    if (from.channels() == kWithOpacity) {
        const auto samples = light.samples();
        for (std::size_t k = 0; k < samples.size(); k += kWithOpacity) {
            for (std::size_t channel = 0; channel + 1 < kWithOpacity; ++channel) {
                samples[k + channel] *= samples[k + kWithOpacity - 1];
            }
        }
    }
    return light;
}

}  // namespace foam::texgen
