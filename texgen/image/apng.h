// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Joins pictures, each encoded as a PNG, into an animation that repeats endlessly (APNG, third
/// edition of the PNG specification). Programs that do not support APNG show its first frame. The
/// color space and the texts of the first frame apply to all frames.
class ApngMuxer {
  public:
    /// Starts an animation of `frames` frames. Throws std::invalid_argument unless `frames` is
    /// positive and both members of `rate` are from 1 to 65535.
    ApngMuxer(int frames, FrameRate rate);

    /// Appends the next frame, encoded by encode_png. Throws std::invalid_argument if the stream is
    /// not a PNG or has a palette, if its size or type of samples differs from the first frame, or
    /// if all frames have already been added.
    void add(std::span<const std::byte> png);

    /// Completes the stream and returns it. May be called only once. Throws std::invalid_argument
    /// unless all frames have been added.
    Bytes finish();

  private:
    void check_header(std::span<const std::byte> header);
    void append_animation();
    void append_frame();
    void append_data(std::span<const std::byte> data);

    int frames_;
    FrameRate rate_;
    int added_ = 0;
    std::uint32_t sequence_ = 0;  // the next sequence number of fcTL and fdAT chunks
    Bytes header_;                // the content of the first frame's IHDR
    Bytes stream_;
};

}  // namespace foam::texgen
