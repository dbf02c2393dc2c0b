// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"

#include "tests/fuzz/fuzz_target.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::fuzz {

namespace {

// The number of frames of the preset, all of which an empty range selects.
constexpr int kFrames = 24;

}  // namespace

void fuzz_frame_range(std::string_view input) {
    const auto frames = unless_rejected<std::invalid_argument>(
        [&] { return texgen::frames_or_all(input, kFrames); });
    if (!frames) {
        return;
    }
    require(!frames->empty(), "a range selects a frame");
    const std::string written = texgen::format_frame_range(*frames);
    require(texgen::parse_frame_range(written) == *frames, "a range is read as it was written");
}

}  // namespace foam::fuzz
