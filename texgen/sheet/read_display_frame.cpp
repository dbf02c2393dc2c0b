// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/image/color.h"
#include "texgen/image/picture.h"
#include "texgen/image/primaries.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

// Integer codes are decoded by a table. Floats are scaled to [0, 1] from the range in the manifest.
// Transparent colors are composited over the background (kBackgroundGray) in linear light.

// Returns true if the samples of a map are colors.
bool stores_colors(const ManifestMap& map) {
    return map.samples->color_space != "data";
}

// Returns true if the images of a map have an opacity. The channel A of a packed image is data, not
// opacity.
bool stores_opacity(const ManifestMap& map) {
    return map.samples->alpha != "none";
}

// Returns a table with the value of each code of the sample type, from 0 to 1. Codes of colors are
// sRGB, and their values are linear light. The value of a data code is the code divided by the
// largest code.
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

// Returns the frame of an image of codes. If the map has an opacity and the image has two or four
// channels, the last channel is the opacity.
template <class Sample>
DisplayFrame shown_codes(const Image<Sample>& image, const ManifestMap& map) {
    const bool is_light = stores_colors(map);
    const std::vector<float> values = values_of_codes<Sample>(is_light);
    const bool has_alpha = stores_opacity(map) && image.channels() % 2 == 0;
    const float background = values[kBackgroundGray * (values.size() - 1) / 255];
    DisplayFrame frame{Image<float>(image.width(), image.height(), DisplayFrame::kColors),
                       is_light};
    const auto from = image.samples();
    const auto step = static_cast<std::size_t>(image.channels());
    // The step from one color of a pixel to the next: 0 for gray, whose first sample is used for
    // all three colors.
    const std::size_t color_step = step >= DisplayFrame::kColors ? 1 : 0;
    float* to = frame.pixels.samples().data();
    for (std::size_t k = 0; k < from.size(); k += step) {
        const float opacity = has_alpha ? static_cast<float>(from[k + step - 1]) /
                                              static_cast<float>(values.size() - 1)
                                        : 1.0F;
        for (std::size_t c = 0; c < DisplayFrame::kColors; ++c) {
            *to++ = opacity * values[from[k + c * color_step]] + (1.0F - opacity) * background;
        }
    }
    return frame;
}

using Channels = std::vector<PictureChannel>;

// Returns the channel with the given name, or nullptr if there is none or its samples are not
// floats.
const PictureChannel* find_channel(const Channels& channels, std::string_view name) {
    const auto found = std::ranges::find(channels, name, &PictureChannel::name);
    const bool is_number =
        found != channels.end() && std::holds_alternative<Image<float>>(found->group->samples);
    return is_number ? &*found : nullptr;
}

// Returns the channels that are shown as red, green and blue: R, G and B, or X, Y and Z if there is
// no R. If there is neither R nor X, Y is shown as gray. A missing channel is null and shown as 0.
std::array<const PictureChannel*, DisplayFrame::kColors> channels_shown(const Channels& channels) {
    if (const PictureChannel* const red = find_channel(channels, "R")) {
        return {red, find_channel(channels, "G"), find_channel(channels, "B")};
    }
    const PictureChannel* const y = find_channel(channels, "Y");
    if (const PictureChannel* const x = find_channel(channels, "X")) {
        return {x, y, find_channel(channels, "Z")};
    }
    return {y, y, y};
}

// Clamps a value to [0, 1]; NaN becomes 0.
float clamped(double value) {
    return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
}

// Calls visit(pixel, number) for each pixel of an image. `number` is the value of the channel at
// the position of the pixel.
void visit_numbers(Image<float>& pixels, const PictureChannel& channel, const auto& visit) {
    std::vector<double> row(static_cast<std::size_t>(pixels.width()));
    for (int y = 0; y < pixels.height(); ++y) {
        read_numbers(channel, y, row);
        for (int x = 0; x < pixels.width(); ++x) {
            visit(pixels.pixel(x, y), row[static_cast<std::size_t>(x)]);
        }
    }
}

// Composites premultiplied colors over the background.
void add_background(Image<float>& pixels, const PictureChannel& opacity) {
    const auto background = static_cast<float>(srgb_to_linear(kBackgroundGray / 255.0));
    visit_numbers(pixels, opacity, [&](std::span<float> pixel, double covered) {
        for (float& color : pixel) {
            color += (1.0F - clamped(covered)) * background;
        }
    });
}

[[noreturn]] void reject(const MapFile& file, std::string_view reason) {
    throw InputError(fmt::format("cannot show '{}': {}", file.path.string(), reason));
}

// Returns the names of channels, separated by spaces.
std::string names_of(const Channels& channels) {
    std::string names;
    for (const PictureChannel& channel : channels) {
        names += names.empty() ? "" : " ";
        names += channel.name;
    }
    return names;
}

// Returns the frame of a picture of floats.
DisplayFrame shown_numbers(const Picture& picture, const MapFile& file, const ManifestMap& map) {
    const Channels channels = channels_of(picture);
    const std::array<const PictureChannel*, DisplayFrame::kColors> colors =
        channels_shown(channels);
    const bool is_light = stores_colors(map);
    if (colors.front() == nullptr) {
        reject(file,
               fmt::format("it has no channel R, X or Y of floats; its channels are {}",
                           names_of(channels)));
    }
    if (!is_light && !map.samples->range) {
        reject(file, "the manifest does not give the range of its numbers");
    }
    const auto [low, high] = map.samples->range.value_or(std::array{0.0, 1.0});
    const double scale = 1.0 / (high - low);
    DisplayFrame frame{Image<float>(picture.width(), picture.height(), DisplayFrame::kColors),
                       is_light};
    for (std::size_t c = 0; c < colors.size(); ++c) {
        if (colors.at(c) != nullptr) {
            visit_numbers(frame.pixels, *colors.at(c), [&, low = low](auto pixel, double number) {
                pixel[c] = clamped((number - low) * scale);
            });
        }
    }
    const PictureChannel* const opacity = find_channel(channels, "A");
    if (stores_opacity(map) && opacity != nullptr) {
        add_background(frame.pixels, *opacity);
    }
    return frame;
}

}  // namespace

DisplayFrame read_display_frame(const MapFile& file, const ManifestMap& map) {
    Picture picture = read_map_frame(file, map.name);
    if (stores_colors(map)) {
        convert_colors(picture, "", picture.metadata.primaries, Primaries::Srgb);
    }
    const Samples& samples = picture.groups.front().samples;
    if (const auto* const codes = std::get_if<Image<std::uint8_t>>(&samples)) {
        return shown_codes(*codes, map);
    }
    if (const auto* const codes = std::get_if<Image<std::uint16_t>>(&samples)) {
        return shown_codes(*codes, map);
    }
    return shown_numbers(picture, file, map);
}

}  // namespace foam::texgen
