// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

#include <array>

namespace foam::texgen {

/// The kinds of loops, which differ in how the last frame leads back to the first frame.
enum class LoopKind {
    None,      // no loop: the last frame does not lead back to the first
    Breathe,   // the area of every bubble oscillates, with a phase of its own (E9)
    Shear,     // the torus is sheared to and fro; before the foam is drawn, it is sheared back, so
               // that images tile
    Boil,      // some bubbles shrink, vanish and are born again, each once in the loop (E9)
    Drift,     // the foam does not change, but moves as a whole
    Flow,      // bubbles vanish, as many new ones appear, and the end fades into the beginning
    PingPong,  // states of the foam, forwards in the first half, backwards in the second
};

/// The largest amplitude of the strain of a shear loop.
inline constexpr double kMaxShearAmplitude = 0.4;

/// A loop of frames.count frames: the last frame is followed by the first frame. In Breathe, Shear,
/// Boil and Drift the foam itself returns to its first state, and no gas diffuses in the loop.
struct LoopOptions {
    LoopKind kind = LoopKind::None;
    // Breathe: relative amplitude of the areas of all bubbles. Boil: relative amplitude of the
    // areas of the bubbles that do not vanish. Shear: amplitude of the strain.
    double amplitude = 0.15;
    double boiling = 0.15;  // Boil: fraction of the bubbles that vanish and are born again
    // Boil: largest rise of the areas of these bubbles above the area at birth, in units of their
    // areas before the loop. If the foam does not return to the same state near some of these
    // bubbles, their rise is reduced (Cycle::calm).
    double rise = 2.5;
    std::array<int, 2> drift = {0, 0};  // motion per loop, in image widths and heights; y is up
    // The root mean square of the strain from a current, which moves the drawn bubbles around and
    // back to their start in every loop.
    double current = 0.0;
    int eddies = 1;  // number of eddies of the current, counted along the shorter side of the image
    /// Breathe, Shear and Boil: the largest number of cycles that are simulated before frame 1.
    /// Cycles are simulated until the foam at the end of a cycle agrees with the foam at its start.
    int cycles = 100;
    /// Flow: the fraction of the frames, at the end of the loop, that are cross-fades. They fade
    /// into the states of the foam that are one loop earlier, which are simulated before frame 1.
    double fade = 1.0;
    /// Flow: regions of the image begin to fade one after the other. The last region begins to fade
    /// after this fraction of the fade.
    double fade_spread = 0.8;
    int growth = 24;  // Flow: number of frames in which a new bubble grows to the mean area

    /// Returns true if the foam itself returns to its first state.
    bool returns_to_start() const { return is_cycle() || kind == LoopKind::Drift; }
    /// Returns true if some frames are a cross-fade: they show one state of the foam in some places
    /// and another state in all others.
    bool is_cross_faded() const { return kind == LoopKind::Flow; }
    /// Returns true if the foam is simulated under a periodic change.
    bool is_cycle() const {
        return kind == LoopKind::Breathe || kind == LoopKind::Shear || kind == LoopKind::Boil;
    }
};

/// Returns the keys of the table `loop` of a preset, without the prefix "loop.".
Keys<LoopOptions> loop_keys();

}  // namespace foam::texgen
