#pragma once

#include "texgen/keys/key.h"

#include <array>

namespace foam::texgen {

/// The way in which the last frame leads back to the first.
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
    double amplitude = 0.15;  // Breathe: of the swing of every area, relative; Shear: of the strain
    std::array<int, 2> drift = {0, 0};  // travel in a loop, in widths and heights of the torus
    int cycles = 12;                    // that may pass before frame 1 until the loop closes
    double fade = 1.0;         // Flow: fraction of the frames, at the end, that fade into those
                               // before the first
    double fade_spread = 0.8;  // Flow: 0 fades the whole image at once, towards 1 part by part
    int growth = 24;           // Flow: frames that a new bubble takes to the mean area

    /// Returns true if the foam itself returns, so that the loop may be cut anywhere.
    bool closes_itself() const { return is_cycle() || kind == LoopKind::Drift; }
    bool is_cross_faded() const { return kind == LoopKind::Flow; }
    bool is_cycle() const { return kind == LoopKind::Breathe || kind == LoopKind::Shear; }
};

Keys<LoopOptions> loop_keys();

}  // namespace foam::texgen
