#pragma once

namespace foam::texgen {

/// Frames in so many seconds: 24000 in 1001.
struct FrameRate {
    int frames = 24;
    int seconds = 1;

    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

}  // namespace foam::texgen
