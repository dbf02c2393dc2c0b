// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief.h"

#include <string>
#include <string_view>

namespace foam::texgen {

inline constexpr MapTraits kNormalMap = {
    .name = "normal",
    .meaning = "normals of the relief, y up (OpenGL) or down (DirectX)",
    .unit = "-1 to 1; PNG: 0.5 stands for 0",
    .channels = "X Y Z",
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::DistanceAndGradient,
    .mixing = Mixing::Slopes,
    .shows_relief = true};

/// Returns the traits of a map that differs from the map `normal` in one respect: its y has a fixed
/// direction. A bake that draws normal_gl and normal_dx has normals for both conventions.
constexpr MapTraits fixed_normal_traits(std::string_view name, std::string_view meaning) {
    MapTraits traits = kNormalMap;
    traits.name = name;
    traits.meaning = meaning;
    return traits;
}

inline constexpr MapTraits kNormalGlMap =
    fixed_normal_traits("normal_gl", "normals of the relief, y up (OpenGL)");
inline constexpr MapTraits kNormalDxMap =
    fixed_normal_traits("normal_dx", "normals of the relief, y down (DirectX)");

/// The direction in which the second channel (green in a PNG) is positive.
enum class NormalY {
    Up,    // convention of OpenGL, used by Blender, Godot and Unity
    Down,  // convention of DirectX, used by Unreal
};

struct NormalOptions {
    NormalY y = NormalY::Up;
};

Keys<NormalOptions> normal_keys();

/// Draws the unit normals of the relief, computed from its slopes: x to the right, y up or down
/// (options.y), z toward the viewer. The image has three channels with values from -1 to 1; they
/// are (0, 0, 1) where the relief is flat.
NumberPixels draw_normal(FrameLayers& layers,
                         const ReliefSource& source,
                         const NormalOptions& options);

/// Returns "y up (OpenGL)" or "y down (DirectX)".
std::string note_on_normals(const NormalOptions& options);

}  // namespace foam::texgen
