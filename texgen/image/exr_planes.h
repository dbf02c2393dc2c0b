// SPDX-License-Identifier: Apache-2.0

#pragma once

// Converts samples to the layout that OpenEXR writes. Only exr_encode.cpp, exr_zip.cpp and a
// benchmark use these declarations.

#include "core/files/file_io.h"
#include "texgen/image/exr.h"

#include <OpenEXR/ImfFrameBuffer.h>

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {

/// The width and height of a channel in pixels.
struct ExrSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const ExrSize&, const ExrSize&) = default;
};

/// Returns the width and height of the samples of a channel.
ExrSize size_of(const ExrChannel& channel);

/// Returns the type of OpenEXR that corresponds to a sample type. Throws std::invalid_argument for
/// Uint8 and Uint16, the types of codes.
Imf::PixelType pixel_type(SampleType type);

/// Throws std::invalid_argument with a message that ends with `why`.
[[noreturn]] void reject_exr(const std::string& why);

/// Returns the channels of a picture in alphabetical order. The channels refer to the samples of
/// the picture, so the picture must outlive them. Throws std::invalid_argument if the samples are
/// codes of 8 or 16 bits.
std::vector<ExrChannel> exr_channels(const Picture& picture);

/// The samples of a channel, converted to the type that a file stores, with the top row first.
struct ExrPlane {
    std::string name;
    SampleType type = SampleType::Half;
    Bytes samples;
    std::size_t row_bytes = 0;

    /// Returns the samples of a row. Rows are counted from the top.
    std::span<const std::byte> row(int index) const {
        return std::span(samples).subspan(static_cast<std::size_t>(index) * row_bytes, row_bytes);
    }
};

/// All channels of one mip level in the layout that OpenEXR writes.
class ExrPlanes {
  public:
    /// Converts the samples. Precondition: there is at least one channel, and all channels have the
    /// same width and height. Throws std::invalid_argument for a number that is not finite or that
    /// its type cannot hold.
    explicit ExrPlanes(std::span<const ExrChannel> channels);

    /// Returns the channels, sorted by name as in the file.
    std::span<const ExrPlane> planes() const { return planes_; }
    int height() const { return size_.height; }

    /// Returns the frame buffer for OpenEXR. It refers to the memory of this object.
    Imf::FrameBuffer buffer();

  private:
    ExrSize size_;
    std::vector<ExrPlane> planes_;
};

/// Computes the mip levels of channels one after the other, beginning with the full size.
class ExrLevels {
  public:
    /// Begins with the full size. Refers to the samples of the channels until the first call of
    /// `advance` returns.
    explicit ExrLevels(std::span<const ExrChannel> channels)
        : channels_(channels.begin(), channels.end()) {}

    /// Returns the channels of the current level, valid until the next call of `advance`.
    std::span<const ExrChannel> channels() const { return channels_; }

    /// Replaces the channels by the channels of the next smaller level.
    void advance();

  private:
    std::vector<ExrChannel> channels_;
    // The samples to which `channels_` refers; empty at the full size, whose samples the caller
    // owns.
    std::vector<std::variant<Image<float>, Image<std::uint32_t>>> levels_;
};

}  // namespace foam::texgen
