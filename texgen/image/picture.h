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

/// The type of a sample in a file: a code of 8 or 16 bits, a floating-point number of 16 bits (up
/// to 65504, with 11 bits of precision) or 32 bits, or an integer of 32 bits.
enum class SampleType : std::uint8_t { Uint8, Uint16, Half, Float, Uint32 };

/// Returns the names of all sample types in the order of the enumeration: "uint8", "uint16",
/// "half", "float", "uint32".
std::span<const std::string_view> sample_type_names();
std::string_view name_of(SampleType type);

/// Samples in memory. Half floats are converted to floats.
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

/// Properties of the samples that a file records. A format omits the members that it cannot store.
struct ImageMetadata {
    /// True if the samples are colors with the primaries and the white point of sRGB. Codes are
    /// encoded with the sRGB transfer function; numbers are linear light. False for data, such as
    /// heights or ids: the file then carries no color space, so that readers do not convert the
    /// values.
    bool color = false;
    bool periodic = false;  // the picture tiles in both directions
    std::optional<FrameRate> frame_rate = {};
    /// Keywords and UTF-8 texts. A keyword has 1 to 31 printable ASCII characters.
    std::vector<std::pair<std::string, std::string>> text = {};
};

/// A picture as a file stores it: one group of interleaved codes, or groups of numbers. All groups
/// have the same size.
struct Picture {
    std::vector<ChannelGroup> groups;
    ImageMetadata metadata = {};

    int width() const { return groups.front().width(); }
    int height() const { return groups.front().height(); }
};

/// Returns the names of the channels of a picture of codes, one letter per channel: "Y", "YA",
/// "RGB" or "RGBA". Precondition: 1 to 4 channels.
std::string_view code_channel_names(int channels);

/// Returns a group with the samples of an image of codes and the names of its channels.
ChannelGroup code_channels(Image<std::uint8_t> codes);
ChannelGroup code_channels(Image<std::uint16_t> codes);

/// Returns the groups of one layer. A group without a layer belongs to every layer.
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
