#pragma once

// Only exr_encode.cpp uses this: samples on their way into OpenEXR.

#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"

#include <OpenEXR/ImfFrameBuffer.h>

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {

struct ExrSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const ExrSize&, const ExrSize&) = default;
};

ExrSize size_of(const ExrChannel& channel);

Imf::PixelType pixel_type(SampleType type);

[[noreturn]] void refuse_exr(const std::string& why);

/// The channels of a picture, which is borrowed. Throws std::invalid_argument for codes.
std::vector<ExrChannel> exr_channels(const Picture& picture);

/// All channels of one level as the library takes them: each by itself, the top row first, in the
/// type of the file. Throws as encode_exr for numbers that this type cannot hold.
class ExrPlanes {
  public:
    explicit ExrPlanes(std::span<const ExrChannel> channels);

    const Imf::FrameBuffer& buffer() const { return buffer_; }

  private:
    std::vector<Bytes> rows_;
    Imf::FrameBuffer buffer_;
};

/// The channels of one mip level after the other.
class ExrLevels {
  public:
    explicit ExrLevels(std::span<const ExrChannel> channels)
        : channels_(channels.begin(), channels.end()) {}

    std::span<const ExrChannel> channels() const { return channels_; }

    /// Goes on to the next smaller level.
    void advance();

  private:
    std::vector<ExrChannel> channels_;
    std::vector<std::variant<Image<float>, Image<std::uint32_t>>> levels_;
};

}  // namespace foam::texgen
