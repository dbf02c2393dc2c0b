// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// A frame rate as a fraction: `frames` frames in `seconds` seconds. For example, 24000 frames in
/// 1001 seconds are about 23.976 frames per second.
struct FrameRate {
    int frames = 24;
    int seconds = 1;

    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

}  // namespace foam::texgen
