// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief_options.h"

#include <string>

namespace foam::texgen {

inline constexpr MapTraits kNormalMap = {
    .name = "normal",
    .meaning = "normals of the relief, y up (OpenGL) or down (DirectX)",
    .unit = "-1 to 1; PNG: 0.5 is 0",
    .channels = "X Y Z",
    .png_filter = PngFilter::Up,
    .smooth_distance = SmoothDistance::Used,
    .around = 1.0,
    .mixing = Mixing::Slopes};

/// The direction of the green channel of a normal map.
enum class NormalY {
    Up,    // OpenGL: Blender, Godot, Unity
    Down,  // DirectX: Unreal
};

struct NormalOptions {
    NormalY y = NormalY::Up;
};

Keys<NormalOptions> normal_keys();

/// Draws the unit normals of the relief from its slopes: x to the right, z towards the viewer. The
/// image has three channels with values from -1 to 1; they are (0, 0, 1) where the relief is flat.
NumberPixels draw_normal(FrameLayers& layers,
                         const ReliefOptions& relief,
                         const NormalOptions& options);

/// Returns "y up (OpenGL)" or "y down (DirectX)".
std::string note_on_normals(const NormalOptions& options);

}  // namespace foam::texgen
