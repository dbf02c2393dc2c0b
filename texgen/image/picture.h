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

/// The type of a sample in a file. Uint8 and Uint16 are codes: unsigned integers whose largest
/// value represents the number 1. Half (up to 65504, with 11 bits of precision) and Float are
/// floating-point numbers of 16 and 32 bits. Uint32 is an integer that is not scaled, such as the
/// id of a bubble.
enum class SampleType : std::uint8_t { Uint8, Uint16, Half, Float, Uint32 };

/// Returns the names of all sample types in the order of the enumeration: "uint8", "uint16",
/// "half", "float", "uint32".
std::span<const std::string_view> sample_type_names();

/// Returns the name of a sample type, such as "uint8".
std::string_view name_of(SampleType type);

/// Samples in memory. Samples of the types Half and Float are both stored as floats.
using Samples =
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<float>, Image<std::uint32_t>>;

/// Some channels of a picture. The samples of these channels are interleaved in one image.
struct ChannelGroup {
    /// One name per channel, such as "R". A name such as "height.Y" is the channel Y of the layer
    /// "height".
    std::vector<std::string> names;
    SampleType type = SampleType::Uint8;
    Samples samples;

    int width() const;
    int height() const;
    int channels() const;
    bool has_codes() const { return type == SampleType::Uint8 || type == SampleType::Uint16; }
};

/// The primaries and the white point of the colors of a picture (chromaticities_of in primaries.h).
/// The primaries of sRGB are also the primaries of ITU-R BT.709.
enum class Primaries : std::uint8_t { Srgb, AcesCg };

/// Properties of a picture that its file records. A format omits the members that it cannot store.
struct ImageMetadata {
    /// True if the samples are colors. Codes are encoded with the sRGB transfer function; numbers
    /// are linear light. False for data, such as heights or ids: the file then carries no color
    /// space, so that readers do not convert the values.
    bool color = false;
    /// The primaries of the colors; unused if `color` is false. Only an EXR stores other primaries
    /// than Srgb.
    Primaries primaries = Primaries::Srgb;
    bool periodic = false;  // the picture tiles in both directions
    std::optional<FrameRate> frame_rate = {};
    /// Keywords and UTF-8 texts. To be accepted by the encoders of all formats, a keyword must have
    /// 1 to 31 printable ASCII characters and satisfy the rules in png.h and exr.h.
    std::vector<std::pair<std::string, std::string>> text = {};
};

/// A picture as a file stores it: either one group of codes, or any number of groups of
/// floating-point numbers and 32-bit integers. All groups have the same width and height.
struct Picture {
    std::vector<ChannelGroup> groups;
    ImageMetadata metadata = {};

    int width() const { return groups.front().width(); }
    int height() const { return groups.front().height(); }
};

/// Returns the names of the channels of a picture of codes, one letter per channel: "Y", "YA",
/// "RGB" or "RGBA". Precondition: 1 to 4 channels.
std::string_view code_channel_names(int channels);

/// Returns a group that holds the samples of an image of codes. Its channels have the names that
/// code_channel_names returns.
ChannelGroup code_channels(Image<std::uint8_t> codes);
ChannelGroup code_channels(Image<std::uint16_t> codes);

/// Returns the layer of a channel, given the name of the channel: the text before the last dot.
/// Returns an empty text if the name has no dot.
std::string_view layer_of(std::string_view channel);

/// Returns pointers to the groups of one layer (layer_of). A group whose channels have no layer
/// belongs to every layer. Precondition: all channels of a group are in the same layer.
std::vector<const ChannelGroup*> groups_of(const Picture& picture, std::string_view layer);

/// One channel of a picture. Refers to the picture, which must outlive it.
struct PictureChannel {
    std::string_view name;
    const ChannelGroup* group = nullptr;
    int index = 0;  // index of the channel in the group
};

/// Returns all channels of a picture in alphabetical order of their names.
std::vector<PictureChannel> channels_of(const Picture& picture);

/// Writes the samples of one row of a channel to `to` as numbers. Codes are scaled so that the
/// largest code becomes 1. Floating-point numbers and 32-bit integers are not scaled. Row 0 is the
/// bottom row. Precondition: the size of `to` is the width of the picture.
void read_numbers(const PictureChannel& channel, int row, std::span<double> to);

}  // namespace foam::texgen
