#pragma once

#include "core/dynamics/coarsening.h"
#include "core/dynamics/solver.h"
#include "core/foam/seeding.h"
#include "texgen/events/all_events.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/camera_options.h"
#include "texgen/preset/foam_shape.h"
#include "texgen/preset/frames_options.h"
#include "texgen/preset/image_options.h"
#include "texgen/preset/loop.h"
#include "texgen/preset/output_options.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The solver that brings the foam to equilibrium, and its accuracy.
struct SolverOptions {
    Solver solver = Solver::Newton;
    double tolerance = 1e-9;  // of every area, relative, and every angle, in radians
};

/// Everything that decides the pixels of a bake. Each value that the user may set is a key; see
/// preset_keys.h and all_events.h. The aspect of a torus has no key: it follows from the image.
struct Preset {
    std::string name;  // of the shipped preset or the stem of the file; fills {preset}
    std::string description;
    FoamShape shape;
    SeedingOptions seeding;
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
};

}  // namespace foam::texgen
