// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/frame_rate.h"
#include "texgen/image/image.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

/// How a file stores one sample: codes of 8 or 16 bits, numbers in 16 bits (up to 65504, with 11
/// bits of precision) or 32 bits, or integers of 32 bits.
enum class SampleType : std::uint8_t { Uint8, Uint16, Half, Float, Uint32 };

/// The names of all sample types, in the order of the enumeration: "uint8", "uint16", "half",
/// "float", "uint32".
std::span<const std::string_view> sample_type_names();
std::string_view name_of(SampleType type);

/// Samples in memory. Halves are widened to floats.
using Samples =
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<float>, Image<std::uint32_t>>;

/// Channels of a picture whose samples are interleaved in one image.
struct ChannelGroup {
    std::vector<std::string> names;  // one per channel: "R"; "height.Y" is in the layer "height"
    SampleType type = SampleType::Uint8;
    Samples samples;

    int width() const;
    int height() const;
    int channels() const;
    bool has_codes() const { return type == SampleType::Uint8 || type == SampleType::Uint16; }
};

/// Properties of the samples that a file records. A format that cannot store a member leaves it
/// out.
struct ImageMetadata {
    /// The samples are colors with the primaries and the white of sRGB: encoded with its transfer
    /// function where samples are codes, linear light where they are numbers. Data, such as a
    /// height or an id, carries no color space, so that no reader bends the values.
    bool color = false;
    bool periodic = false;  // the picture tiles in both directions
    std::optional<FrameRate> frame_rate = {};
    /// Keywords and UTF-8 texts. A keyword has 1 to 31 printable ASCII characters.
    std::vector<std::pair<std::string, std::string>> text = {};
};

/// A picture as a file holds it: one group of interleaved codes, or groups of numbers. All groups
/// have one size.
struct Picture {
    std::vector<ChannelGroup> groups;
    ImageMetadata metadata = {};

    int width() const { return groups.front().width(); }
    int height() const { return groups.front().height(); }
};

/// The names of the channels of a picture of codes, one letter each: "Y", "YA", "RGB" or "RGBA".
/// Precondition: 1 to 4 channels.
std::string_view code_channel_names(int channels);

/// Names the channels of an image of codes.
ChannelGroup code_channels(Image<std::uint8_t> codes);
ChannelGroup code_channels(Image<std::uint16_t> codes);

/// The groups of one layer. A group without a layer belongs to every layer.
std::vector<const ChannelGroup*> groups_of(const Picture& picture, std::string_view layer);

/// One channel of a picture; borrows the picture.
struct PictureChannel {
    std::string_view name;
    const ChannelGroup* group = nullptr;
    int index = 0;  // in the group
};

/// Returns all channels of a picture in the order of their names.
std::vector<PictureChannel> channels_of(const Picture& picture);

/// Reads a row of a channel as numbers. Codes are scaled so that the largest code is 1; numbers and
/// 32-bit integers are not scaled. Row 0 is the bottom row. Precondition: the size of `to` is the
/// width of the picture.
void read_numbers(const PictureChannel& channel, int row, std::span<double> to);

}  // namespace foam::texgen
