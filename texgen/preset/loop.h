#pragma once

#include <array>

namespace foam::texgen {

/// What brings the foam back to where it was, so that the last frame leads into the first.
enum class LoopKind {
    None,      // nothing: the foam ages
    Breathe,   // every bubble swells and shrinks, each in its own time (E9)
    Shear,     // the torus shears to and fro; images ride with it, and stay tiles
    Drift,     // the foam stands still, and travels as a whole
    Flow,      // bubbles vanish, as many come to be, and the end fades into the beginning
    PingPong,  // the frames of an ageing foam, to the middle and back
};

/// Loops of frames.count frames: the frame after the last is the first. Breathe, Shear and Drift
/// close by themselves, and no gas diffuses once they have begun.
struct LoopOptions {
    LoopKind kind = LoopKind::None;
    // Of Breathe the swing of every area, a part of it; of Shear that of the strain.
    double amplitude = 0.15;
    // Whole widths and heights of a torus that all travels in a loop, right and up.
    std::array<int, 2> drift = {0, 0};
    int cycles = 12;  // at most so many pass before frame 1, for the loop to settle
    // Of Flow: the part of the frames, at the end, that fade into those before the first; and the
    // frames that a new bubble takes to the mean area.
    double fade = 1.0;
    double fade_spread = 0.8;  // 0: the image at once, towards 1: place by place
    int growth = 24;

    /// The foam itself returns: the frame after the last is the first, wherever the loop is cut.
    bool closes_itself() const { return is_cycle() || kind == LoopKind::Drift; }
    bool is_cross_faded() const { return kind == LoopKind::Flow; }
    bool is_cycle() const { return kind == LoopKind::Breathe || kind == LoopKind::Shear; }
};

}  // namespace foam::texgen
