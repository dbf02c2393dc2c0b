#pragma once

#include "core/dynamics/coarsening.h"
#include "core/dynamics/solver.h"
#include "core/foam/seeding.h"
#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/maps/map_options.h"
#include "texgen/preset/event.h"
#include "texgen/preset/foam_shape.h"
#include "texgen/preset/loop.h"

#include <array>
#include <string>
#include <vector>

namespace foam::texgen {

/// How the foam is brought to equilibrium, and how near.
struct SolverOptions {
    Solver solver = Solver::Newton;
    double tolerance = 1e-9;  // of every area, relative, and every angle, in radians
};

/// What frame 1 shows: the foam, or the diagram that it is made from, before equilibrium.
enum class FirstFrame { Equilibrium, Diagram };

/// Which instants of the foam become pictures: frame 1 shows the foam at time warm_up, frame i + 1
/// at time_step step_growth^(i - 1) after frame i.
struct FramesOptions {
    int count = 48;
    FirstFrame first = FirstFrame::Equilibrium;
    double time_step = 1.0;    // foam time from frame 1 to frame 2
    double step_growth = 1.0;  // of the time from frame to frame
    double warm_up = 0.0;      // foam time simulated before frame 1
};

/// What is drawn of a frame.
struct ImageOptions {
    int width = 1024;  // pixels
    int height = 1024;
    std::vector<std::string> maps = {"albedo"};
};

/// What the image shows of the plane, in which a patch lies; the same in every frame. Nothing moves
/// with it: the patch as it is in the first frame decides.
struct CameraOptions {
    double zoom = 1.0;     // 1 fits the whole patch
    double margin = 0.05;  // around it at zoom 1, in parts of the image's shorter side
    // Of what zoom 1 shows, the place that comes to the middle, in parts of the image from its
    // lower left.
    std::array<double, 2> center = {0.5, 0.5};
};

/// Whether files carry texts about how they were made.
enum class FileTexts { Written, LeftOut };

/// How the pixels of an EXR lie in the file.
enum class ExrLayout { Rows, MipLevels };

/// Where the images go, and in what form; none of it changes a pixel.
struct OutputOptions {
    std::string pattern = "out/{preset}_{map}.####.png";  // as FilePattern reads it
    FileTexts texts = FileTexts::Written;
    int frames_per_second = 24;  // as an EXR says
    Compression png_compression = Compression::Fast;
    ExrCompression exr_compression = ExrCompression::Zip;
    int exr_level = 2;                     // of zip and zips, 1 to 9
    ExrType exr_numbers = ExrType::Float;  // or Half
    ExrLayout exr_layout = ExrLayout::Rows;
};

/// Everything that decides the pixels of a bake. Each value the user may set is one key of the
/// schema, see schema.h and event_schema.h; the aspect of a torus is none: it follows from the
/// image.
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
