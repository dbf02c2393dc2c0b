// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/number_channels.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace foam::texgen {

namespace {

// Removes the first word from a text and returns it. Returns an empty word if the text is empty.
std::string_view take_word(std::string_view& words) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    return word;
}

Samples samples_of(MapImage map) {
    if (const auto* colors = std::get_if<ColorPixels>(&map)) {
        return premultiplied(*colors);
    }
    if (auto* numbers = std::get_if<NumberPixels>(&map)) {
        return std::move(numbers->pixels);
    }
    return std::move(std::get<IdPixels>(map).pixels);
}

}  // namespace

ChannelGroup number_channels(MapImage map, const ChannelNames& names, SampleType type_of_numbers) {
    const SampleType type = number_type(map, type_of_numbers);
    ChannelGroup group{{}, type, samples_of(std::move(map))};
    const std::string prefix = names.layer.empty() ? "" : std::string(names.layer) + '.';
    std::string_view rest = names.channels;
    for (int k = 0; k < group.channels(); ++k) {
        const std::string_view word = take_word(rest);
        group.names.push_back(prefix + (word.empty() ? "A" : std::string(word)));
    }
    return group;
}

SampleType number_type(const MapImage& map, SampleType type_of_numbers) {
    if (std::holds_alternative<ColorPixels>(map)) {
        return SampleType::Half;
    }
    return std::holds_alternative<IdPixels>(map) ? SampleType::Uint32 : type_of_numbers;
}

Image<float> premultiplied(const ColorPixels& colors) {
    const Image<std::uint16_t>& from = colors.pixels;
    Image<float> light(from.width(), from.height(), from.channels());
    std::ranges::transform(from.samples(), light.samples().begin(), [](std::uint16_t value) {
        return static_cast<float>(value) / static_cast<float>(kWhite);
    });
    if (from.channels() == kChannelsWithOpacity) {
        const auto samples = light.samples();
        for (std::size_t k = 0; k < samples.size(); k += kChannelsWithOpacity) {
            for (std::size_t channel = 0; channel + 1 < kChannelsWithOpacity; ++channel) {
                samples[k + channel] *= samples[k + kChannelsWithOpacity - 1];
            }
        }
    }
    return light;
}

}  // namespace foam::texgen
