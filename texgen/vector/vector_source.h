// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/vector/mesh_options.h"
#include "texgen/vector/vector_options.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The options that vector files depend on. Borrows the options.
struct VectorSettings {
    const MapOptions& maps;
    const VectorOptions& drawing;
    const MeshOptions& mesh;
    std::vector<std::string> map_names;  // image.maps of the preset
    int width = 0;                       // width of the images of the preset, in pixels
    int height = 0;                      // height of these images, in pixels
};

/// A frame, the options on which its vector files depend, and the texts in these files. Borrows the
/// layers.
struct VectorSource {
    FrameLayers& layers;
    VectorSettings settings;
    std::string title;        // title of a drawing, or name of a mesh
    std::string description;  // written to SVG files; may be empty
};

}  // namespace foam::texgen
