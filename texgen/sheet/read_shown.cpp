// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/color.h"
#include "texgen/image/file_io.h"
#include "texgen/image/picture.h"
#include "texgen/sheet/map_frame.h"
#include "texgen/sheet/shown_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

// Integer samples are decoded by a table. Floats are scaled from the range in the manifest to
// [0, 1]. Transparent colors are composited over the ground color in linear light.

bool is_light_in(const ManifestMap& map) {
    return map.samples->color_space != "data";
}

// Returns a table of the values of all codes of a sample, from 0 to 1.
template <class Sample>
std::vector<float> values_of_codes(bool is_light) {
    constexpr std::size_t kCodes = std::size_t{std::numeric_limits<Sample>::max()} + 1;
    std::vector<float> values(kCodes);
    for (std::size_t k = 0; k < kCodes; ++k) {
        const double value = static_cast<double>(k) / static_cast<double>(kCodes - 1);
        values[k] = static_cast<float>(is_light ? srgb_to_linear(value) : value);
    }
    return values;
}

template <class Sample>
ShownFrame shown_codes(const Image<Sample>& image, bool is_light) {
    const std::vector<float> values = values_of_codes<Sample>(is_light);
    const bool has_alpha = image.channels() % 2 == 0;
    const float ground = values[kGround * (values.size() - 1) / 255];
    ShownFrame frame{Image<float>(image.width(), image.height(), ShownFrame::kColors), is_light};
    const auto from = image.samples();
    const auto step = static_cast<std::size_t>(image.channels());
    const std::size_t next =
        step >= ShownFrame::kColors ? 1 : 0;  // gray uses one sample for all three colors
    float* to = frame.pixels.samples().data();
    for (std::size_t k = 0; k < from.size(); k += step) {
        const float opacity = has_alpha ? static_cast<float>(from[k + step - 1]) /
                                              static_cast<float>(values.size() - 1)
                                        : 1.0F;
        for (std::size_t c = 0; c < ShownFrame::kColors; ++c) {
            *to++ = opacity * values[from[k + c * next]] + (1.0F - opacity) * ground;
        }
    }
    return frame;
}

using Channels = std::vector<PictureChannel>;

const PictureChannel* find_channel(const Channels& channels, std::string_view name) {
    const auto found = std::ranges::find(channels, name, &PictureChannel::name);
    const bool is_number =
        found != channels.end() && std::holds_alternative<Image<float>>(found->group->samples);
    return is_number ? &*found : nullptr;
}

// Returns the channels that are shown as red, green and blue. A single channel Y is shown as gray.
// A missing channel is null and shown as black.
std::array<const PictureChannel*, ShownFrame::kColors> channels_shown(const Channels& channels) {
    if (const PictureChannel* const gray = find_channel(channels, "Y"); channels.size() == 1) {
        return {gray, gray, gray};
    }
    const bool is_color = find_channel(channels, "R") != nullptr;
    return {find_channel(channels, is_color ? "R" : "X"),
            find_channel(channels, is_color ? "G" : "Y"),
            find_channel(channels, is_color ? "B" : "Z")};
}

// Clamps a value to [0, 1]; NaN becomes 0.
float clamped(double value) {
    return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
}

// Calls visit(pixel, number) for every pixel of a channel.
void visit_numbers(Image<float>& pixels, const PictureChannel& channel, const auto& visit) {
    std::vector<double> row(static_cast<std::size_t>(pixels.width()));
    for (int y = 0; y < pixels.height(); ++y) {
        read_numbers(channel, y, row);
        for (int x = 0; x < pixels.width(); ++x) {
            visit(pixels.pixel(x, y), row[static_cast<std::size_t>(x)]);
        }
    }
}

// Composites premultiplied colors over the ground color.
void add_ground(Image<float>& pixels, const PictureChannel& opacity) {
    const auto ground = static_cast<float>(srgb_to_linear(kGround / 255.0));
    visit_numbers(pixels, opacity, [&](std::span<float> pixel, double covered) {
        for (float& color : pixel) {
            color += (1.0F - clamped(covered)) * ground;
        }
    });
}

[[noreturn]] void reject(const MapFile& file, std::string_view reason) {
    throw InputError(fmt::format("cannot show '{}': {}", file.path.string(), reason));
}

ShownFrame shown_numbers(const Picture& picture, const MapFile& file, const ManifestMap& map) {
    const Channels channels = channels_of(picture);
    const std::array<const PictureChannel*, ShownFrame::kColors> colors = channels_shown(channels);
    const bool is_light = is_light_in(map);
    if (colors.front() == nullptr) {
        reject(file, "it has none of the channels Y, R and X");
    }
    if (!is_light && !map.samples->range) {
        reject(file, "the manifest does not give the range of its numbers");
    }
    const auto [low, high] = map.samples->range.value_or(std::array{0.0, 1.0});
    const double scale = 1.0 / (high - low);
    ShownFrame frame{Image<float>(picture.width(), picture.height(), ShownFrame::kColors),
                     is_light};
    for (std::size_t c = 0; c < colors.size(); ++c) {
        if (colors.at(c) != nullptr) {
            visit_numbers(frame.pixels, *colors.at(c), [&, low = low](auto pixel, double number) {
                pixel[c] = clamped((number - low) * scale);
            });
        }
    }
    if (const PictureChannel* const opacity = find_channel(channels, "A"); is_light && opacity) {
        add_ground(frame.pixels, *opacity);
    }
    return frame;
}

}  // namespace

ShownFrame read_shown(const MapFile& file, const ManifestMap& map) {
    const Picture picture = read_map_frame(file, map.name);
    const Samples& samples = picture.groups.front().samples;
    if (const auto* const codes = std::get_if<Image<std::uint8_t>>(&samples)) {
        return shown_codes(*codes, is_light_in(map));
    }
    if (const auto* const codes = std::get_if<Image<std::uint16_t>>(&samples)) {
        return shown_codes(*codes, is_light_in(map));
    }
    return shown_numbers(picture, file, map);
}

}  // namespace foam::texgen
