// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/packing.h"

#include "texgen/maps/all_maps.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

[[noreturn]] void reject(std::string_view name, const std::string& reason) {
    throw std::invalid_argument(fmt::format("packing '{}': {}", name, reason));
}

std::optional<double> read_constant(std::string_view text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

// Returns the index of a channel of a map.
int channel_of(std::string_view packing, const Map& map, std::optional<std::string_view> channel) {
    const std::vector<std::string_view> all = split(map.channels, ' ');
    if (!channel && all.size() > 1) {
        reject(packing,
               fmt::format("the map {0} has the channels {1}; name one of them, such as {0}.{2}",
                           map.name,
                           map.channels,
                           all.front()));
    }
    const auto found = channel ? std::ranges::find(all, *channel) : all.begin();
    if (found == all.end()) {
        reject(packing,
               fmt::format(
                   "the map {} has no channel '{}', only {}", map.name, *channel, map.channels));
    }
    return static_cast<int>(found - all.begin());
}

PackedChannel parse_map_channel(std::string_view packing, std::string_view text) {
    PackedChannel channel{.text = std::string(text)};
    constexpr std::string_view kInversion = "1-";
    channel.inverted = text.starts_with(kInversion);
    text.remove_prefix(channel.inverted ? kInversion.size() : 0);
    const std::size_t dot = text.find('.');
    try {
        channel.map = &find_map(text.substr(0, dot));
    } catch (const std::invalid_argument& error) {
        reject(packing, error.what());
    }
    if (channel.map->kind == MapKind::Id) {
        reject(packing,
               fmt::format("the map {} has integers, which cannot be packed", channel.map->name));
    }
    if (channel.map->kind == MapKind::Color && channel.inverted) {
        reject(packing, fmt::format("the color {} cannot be inverted", text));
    }
    const bool has_dot = dot != std::string_view::npos;
    channel.channel = channel_of(
        packing, *channel.map, has_dot ? std::optional(text.substr(dot + 1)) : std::nullopt);
    return channel;
}

PackedChannel parse_channel(std::string_view packing, std::string_view text) {
    const std::optional<double> constant = read_constant(text);
    if (!constant) {
        return parse_map_channel(packing, text);
    }
    if (!(*constant >= 0.0 && *constant <= 1.0)) {
        reject(packing, fmt::format("the constant {} is not from 0 to 1", text));
    }
    return {.constant = *constant, .text = std::string(text)};
}

bool is_color(const PackedChannel& channel) {
    return channel.map != nullptr && channel.map->kind == MapKind::Color;
}

// Sets Packing::is_color. Checks that the channel A, if there is one, is data, that is, numbers
// that are not colors. Checks that R, G and B are all colors or all data, and that colors have 8
// bits.
void check_colors(Packing& packing) {
    if (packing.channels.size() > 3 && is_color(packing.channels[3])) {
        reject(packing.name,
               fmt::format("{} is a color, but A must be data", packing.channels[3].text));
    }
    const auto rgb = std::span(packing.channels).first(3);
    const auto color = std::ranges::find_if(rgb, is_color);
    const auto data = std::ranges::find_if_not(rgb, is_color);
    packing.is_color = color != rgb.end();
    if (packing.is_color && data != rgb.end()) {
        reject(packing.name,
               fmt::format("{} is a color, but {} is not; R, G and B must all be colors or all be "
                           "data",
                           color->text,
                           data->text));
    }
    if (packing.is_color && packing.bits != 8) {
        reject(packing.name, "colors have 8 bits per sample");
    }
}

// Parses `text`, the part of the packing `whole` before '='. Returns a packing without channels,
// with the name and the number of bits that `text` gives.
Packing parse_name(std::string_view text, std::string_view whole) {
    Packing packing;
    const std::vector<std::string_view> parts = split(text, ':');
    packing.name = parts.front();
    if (!is_file_word(packing.name)) {
        throw std::invalid_argument(
            fmt::format("packing '{}': the name must have 1 to {} letters, digits, '_' or '-'",
                        whole,
                        kMaxFileWordLength));
    }
    if (parts.size() > 2 || (parts.size() == 2 && parts[1] != "8" && parts[1] != "16")) {
        reject(packing.name, "the number of bits after ':' must be 8 or 16");
    }
    packing.bits = parts.size() == 2 && parts[1] == "16" ? 16 : 8;
    for (const std::string_view map : map_names()) {
        if (lower_case(packing.name) == map) {
            reject(packing.name, "a map has this name; choose another one");
        }
    }
    return packing;
}

// The images of the maps of a packing, each drawn once.
class MapImages {
  public:
    MapImages(const Packing& packing, ShownLayers& content, MapOptions options) {
        options.pressure = without_colors(std::move(options.pressure));
        for (const Map* const map : maps_in(packing)) {
            images_.emplace_back(map, draw(*map, content, options));
        }
    }

    // Returns the image of a map. `Pixels` is its type (MapImage).
    template <class Pixels>
    const Pixels& image_of(const Map& map) const {
        return std::get<Pixels>(std::ranges::find(images_, &map, &Drawn::first)->second);
    }

  private:
    using Drawn = std::pair<const Map*, MapImage>;
    std::vector<Drawn> images_;
};

// Calls write(pixel, value) with the packed number of every pixel. Pixels are counted row by row.
template <class Write>
void for_each_number(const PackedChannel& channel,
                     const MapImages& images,
                     std::size_t pixels,
                     const Write& write) {
    if (channel.map == nullptr) {
        for (std::size_t k = 0; k < pixels; ++k) {
            write(k, static_cast<float>(channel.constant));
        }
        return;
    }
    const NumberPixels& numbers = images.image_of<NumberPixels>(*channel.map);
    const auto channels = static_cast<std::size_t>(numbers.pixels.channels());
    const auto first = static_cast<std::size_t>(channel.channel);
    const double scale = 1.0 / (numbers.high - numbers.low);
    for (std::size_t k = 0; k < pixels; ++k) {
        const auto number = static_cast<double>(numbers.pixels.samples()[channels * k + first]);
        const double fraction = (number - numbers.low) * scale;
        write(k, static_cast<float>(channel.inverted ? 1.0 - fraction : fraction));
    }
}

ColorPixels pack_colors(const Packing& packing, const MapImages& images, const RasterGrid& grid) {
    const auto channels = packing.channels.size();
    Image<std::uint16_t> packed(grid.width, grid.height, static_cast<int>(channels));
    const std::span<std::uint16_t> to = packed.samples();
    for (std::size_t c = 0; c < 3; ++c) {
        const PackedChannel& channel = packing.channels[c];
        const Image<std::uint16_t>& colors = images.image_of<ColorPixels>(*channel.map).pixels;
        const auto from_channels = static_cast<std::size_t>(colors.channels());
        const auto from_channel = static_cast<std::size_t>(channel.channel);
        for (std::size_t k = 0; k * channels < to.size(); ++k) {
            to[channels * k + c] = colors.samples()[from_channels * k + from_channel];
        }
    }
    if (channels > 3) {
        for_each_number(
            packing.channels[3], images, to.size() / channels, [&](std::size_t k, float number) {
                const double fraction = std::clamp(static_cast<double>(number), 0.0, 1.0);
                to[channels * k + 3] = to_sample(fraction);
            });
    }
    return {std::move(packed)};
}

NumberPixels pack_numbers(const Packing& packing, const MapImages& images, const RasterGrid& grid) {
    const auto channels = packing.channels.size();
    Image<float> packed(grid.width, grid.height, static_cast<int>(channels));
    const std::span<float> to = packed.samples();
    for (std::size_t c = 0; c < channels; ++c) {
        for_each_number(
            packing.channels[c], images, to.size() / channels, [&](std::size_t k, float number) {
                to[channels * k + c] = number;
            });
    }
    return {std::move(packed), 0.0, 1.0};
}

}  // namespace

bool is_file_word(std::string_view text) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    return !text.empty() && text.size() <= kMaxFileWordLength &&
           std::ranges::all_of(text, is_allowed);
}

Packing parse_packing(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) {
        throw std::invalid_argument(
            fmt::format("packing '{}': must be NAME=R,G,B or NAME=R,G,B,A, such as "
                        "ORM=occlusion,roughness,metallic",
                        text));
    }
    Packing packing = parse_name(text.substr(0, equals), text);
    const std::vector<std::string_view> channels = split(text.substr(equals + 1), ',');
    if (channels.size() != 3 && channels.size() != 4) {
        reject(packing.name,
               fmt::format("has {} channels instead of 3 or 4: R, G, B and A", channels.size()));
    }
    for (const std::string_view channel : channels) {
        packing.channels.push_back(parse_channel(packing.name, channel));
    }
    check_colors(packing);
    return packing;
}

std::vector<const Map*> maps_in(const Packing& packing) {
    std::vector<const Map*> maps;
    for (const PackedChannel& channel : packing.channels) {
        if (channel.map != nullptr && std::ranges::find(maps, channel.map) == maps.end()) {
            maps.push_back(channel.map);
        }
    }
    return maps;
}

MapImage draw_packed(const Packing& packing, ShownLayers& content, const MapOptions& options) {
    const MapImages images(packing, content, options);
    const RasterGrid& grid = content.layers.grid();
    if (packing.is_color) {
        return pack_colors(packing, images, grid);
    }
    return pack_numbers(packing, images, grid);
}

}  // namespace foam::texgen
