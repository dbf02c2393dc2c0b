#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Joins pictures, each encoded as a PNG, into one that moves, over and over (APNG, in the third
/// edition of the PNG specification). Programs that know PNG alone show its first frame. What that
/// frame says of its samples and its texts holds for all.
class ApngMuxer {
  public:
    /// So many frames will come. Throws std::invalid_argument unless there is at least one, and for
    /// a rate of which either number is beyond 1 to 65535.
    ApngMuxer(int frames, FrameRate rate);

    /// The next frame, as encode_png made it. Throws std::invalid_argument for
    /// another stream, for one of another size or kind of samples than the first, and for a frame
    /// too many.
    void add(std::span<const std::byte> png);

    /// The whole stream. Throws std::invalid_argument unless all frames have come.
    Bytes finish();

  private:
    void check_header(std::span<const std::byte> header);
    void append_animation();
    void append_frame();
    void append_data(std::span<const std::byte> data);

    int frames_;
    FrameRate rate_;
    int added_ = 0;
    std::uint32_t sequence_ = 0;  // the next number of the chunks that animate
    Bytes header_;                // the content of the first frame's IHDR
    Bytes stream_;
};

}  // namespace foam::texgen
