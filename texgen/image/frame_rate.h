// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// A frame rate as a fraction, `frames` in `seconds`: 24000 in 1001 seconds is 23.976 per second.
struct FrameRate {
    int frames = 24;
    int seconds = 1;

    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

}  // namespace foam::texgen
