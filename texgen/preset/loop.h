// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

#include <array>

namespace foam::texgen {

/// The way in which the last frame leads back to the first.
enum class LoopKind {
    None,      // no loop: the foam coarsens
    Breathe,   // every bubble swells and shrinks, each with its own phase (E9)
    Shear,     // the torus shears to and fro; images move with it and remain tileable
    Drift,     // the foam does not change, but moves as a whole
    Flow,      // bubbles vanish and as many new ones appear; the end fades into the beginning
    PingPong,  // the frames of an aging foam, forwards to the middle and backwards to the start
};

/// A loop of frames.count frames: the frame after the last one is the first one. In Breathe, Shear
/// and Drift the foam itself returns to its first state, and no gas diffuses once the loop has
/// begun.
struct LoopOptions {
    LoopKind kind = LoopKind::None;
    double amplitude = 0.15;  // Breathe: relative amplitude of areas; Shear: amplitude of strain
    std::array<int, 2> drift = {0, 0};  // motion per loop, in widths and heights of the torus
    int cycles = 12;    // Breathe, Shear: largest number of cycles simulated before frame 1
    double fade = 1.0;  // Flow: fraction of the frames, at the end of the loop, that fade into
                        // the frames before the first
    double fade_spread =
        0.8;          // Flow: fraction of the fade after which the last region begins to fade
    int growth = 24;  // Flow: number of frames in which a new bubble grows to the mean area

    /// Returns true if the foam itself returns to its first state.
    bool closes_itself() const { return is_cycle() || kind == LoopKind::Drift; }
    /// Returns true if some frames are a mixture of two states of the foam.
    bool is_cross_faded() const { return kind == LoopKind::Flow; }
    /// Returns true if a periodic change of the foam is simulated.
    bool is_cycle() const { return kind == LoopKind::Breathe || kind == LoopKind::Shear; }
};

Keys<LoopOptions> loop_keys();

}  // namespace foam::texgen
