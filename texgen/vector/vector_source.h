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
    int width = 0;                       // of the images of the preset, in pixels
    int height = 0;
};

/// The content of a vector file: a part of a frame, and the options. Borrows the frame.
struct VectorSource {
    FrameLayers& layers;
    VectorSettings settings;
    std::string title;
    std::string description;
};

}  // namespace foam::texgen
