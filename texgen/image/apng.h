// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Joins frames, each encoded as a PNG, into an animation that repeats endlessly (APNG, third
/// edition of the PNG specification). Programs that do not support APNG show the first frame. The
/// color space and the texts of the first frame apply to the whole animation.
class ApngMuxer {
  public:
    /// Starts an animation of `frames` frames at the given frame rate. Throws std::invalid_argument
    /// unless `frames` is positive and both members of `rate` are from 1 to 65535.
    ApngMuxer(int frames, FrameRate rate);

    /// Appends the next frame. `png` is the content of a PNG file without a palette. Precondition:
    /// the PNG is not itself an animation. Throws std::invalid_argument if `png` is not a PNG or
    /// has a palette, or if all frames have already been added. Also throws it if the width,
    /// height, type of samples or interlacing of `png` differs from that of the first frame.
    void add(std::span<const std::byte> png);

    /// Completes the stream and returns it. May be called only once. Throws std::invalid_argument
    /// unless all frames have been added.
    Bytes finish();

  private:
    void check_header(std::span<const std::byte> header);
    void append_animation_control();
    void append_frame_control();
    void append_data(std::span<const std::byte> data);

    int frames_;
    FrameRate rate_;
    int added_ = 0;
    std::uint32_t sequence_ = 0;  // the next sequence number of fcTL and fdAT chunks
    Bytes header_;                // the content of the IHDR chunk of the first frame
    Bytes stream_;
};

}  // namespace foam::texgen
