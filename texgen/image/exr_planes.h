// SPDX-License-Identifier: Apache-2.0

#pragma once

// Converts samples to the layout that OpenEXR writes. Only exr_encode.cpp uses this file.

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

/// Throws std::invalid_argument with a message that ends with `why`.
[[noreturn]] void reject_exr(const std::string& why);

/// Returns the channels of a picture. They refer to the samples of the picture, which must outlive
/// them. Throws std::invalid_argument if the samples are codes of 8 or 16 bits.
std::vector<ExrChannel> exr_channels(const Picture& picture);

/// All channels of one level in the layout that OpenEXR writes: planar, the top row first, in the
/// sample types of the file. Throws std::invalid_argument for a number that its type cannot hold.
class ExrPlanes {
  public:
    explicit ExrPlanes(std::span<const ExrChannel> channels);

    const Imf::FrameBuffer& buffer() const { return buffer_; }

  private:
    std::vector<Bytes> rows_;
    Imf::FrameBuffer buffer_;
};

/// An iterator over mip levels; it holds the channels of the current level.
class ExrLevels {
  public:
    explicit ExrLevels(std::span<const ExrChannel> channels)
        : channels_(channels.begin(), channels.end()) {}

    std::span<const ExrChannel> channels() const { return channels_; }

    /// Replaces the channels by those of the next smaller level.
    void advance();

  private:
    std::vector<ExrChannel> channels_;
    std::vector<std::variant<Image<float>, Image<std::uint32_t>>> levels_;  // memory of `channels_`
};

}  // namespace foam::texgen
