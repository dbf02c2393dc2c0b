#pragma once

#include "texgen/maps/map_image.h"
#include "texgen/maps/relief_options.h"

#include <string>

namespace foam::texgen {

class FrameLayers;

/// Which way the green channel of a normal map points.
enum class NormalY {
    Up,    // OpenGL: Blender, Godot, Unity
    Down,  // DirectX: Unreal
};

struct NormalOptions {
    NormalY y = NormalY::Up;
};

/// The unit normals of the relief, from its slopes: x to the right, z towards the viewer. Three
/// channels, -1 to 1; (0, 0, 1) where it is flat.
NumberPixels draw_normal(FrameLayers& layers,
                         const ReliefOptions& relief,
                         const NormalOptions& options);

/// "y up (OpenGL)".
std::string note_on_normals(const NormalOptions& options);

}  // namespace foam::texgen
