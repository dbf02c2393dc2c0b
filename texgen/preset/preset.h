// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/coarsening.h"
#include "core/dynamics/solver.h"
#include "core/foam/seeding.h"
#include "texgen/events/all_events.h"
#include "texgen/maps/all_maps.h"
#include "texgen/pictures/density.h"
#include "texgen/preset/camera_options.h"
#include "texgen/preset/foam_shape.h"
#include "texgen/preset/frames_options.h"
#include "texgen/preset/image_options.h"
#include "texgen/preset/loop.h"
#include "texgen/preset/output_options.h"
#include "texgen/vector/mesh_options.h"
#include "texgen/vector/vector_options.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The solver that brings the foam to equilibrium, and its accuracy.
struct SolverOptions {
    Solver solver = Solver::Newton;
    /// The foam counts as in equilibrium only if all relative errors of bubble areas, and all
    /// errors of angles in radians, are below this number.
    double tolerance = 1e-9;
};

/// All options that determine the images of a bake. Each value that the user may set has a key; see
/// preset_keys.h and all_events.h. The aspect ratio of a torus has no key, because it follows from
/// the image size.
struct Preset {
    /// The name of the shipped preset, or the file name without its extension. It replaces {preset}
    /// in the names of image files.
    std::string name;
    std::string description;
    // The keys that random variations vary, and their values (parse_varied_key).
    std::vector<std::string> vary;
    FoamShape shape;
    SeedingOptions seeding;  // without `areas`, which are computed from `density`
    DensityOptions density;
    SolverOptions equilibrium;
    CoarseningOptions coarsening;
    TopologyThresholds thresholds;
    FramesOptions frames;
    LoopOptions loop;
    std::vector<Event> events;  // in the order of the file
    ImageOptions image;
    CameraOptions camera;
    MapOptions maps;
    OutputOptions output;
    VectorOptions vector;
    MeshOptions mesh;
};

}  // namespace foam::texgen
