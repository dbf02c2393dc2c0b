// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/bake/written_file.h"
#include "texgen/preset/preset.h"

#include <array>
#include <filesystem>
#include <functional>
#include <set>
#include <vector>

namespace foam::texgen {

/// The frames to bake and how to compute them: options of `bake`, and of bake_recorded
/// (manifest/recorded_bake.h), which bakes, too. If the source simulates the preset or reads a
/// cache of it, the pixels of a frame depend on none of these options, with one exception:
/// bake_recorded fits automatic ranges of maps to the frames in `sequence`.
struct BakeOptions {
    std::vector<int> frames;  // numbers from 1, in any order, each once
    int threads = 0;          // 0: one per hardware thread
    FrameSource source = {};  // source of the frames; if empty, the preset is simulated
    // The frames to which bake_recorded fits automatic ranges of maps; if empty, the frames from 1
    // to frames.count. `bake` does not use it.
    std::vector<int> sequence = {};
    // The folder of the cache from which `source` reads its frames; empty if there is none.
    // bake_recorded reads the automatic ranges of maps from this folder, or stores them in it.
    // `bake` does not use this member.
    std::filesystem::path cache = {};
    std::set<int> existing_frames = {};  // subset of `frames`, whose existing files are kept
};

/// A map or packing that is drawn for every frame, with the range that its codes represent and the
/// extent of its numbers. The extent is joined from all files that a bake has written. It is
/// measured before the numbers are rounded to codes (integer samples).
struct WrittenNumbers {
    DrawnImage image;
    std::array<double, 2> range{};  // the numbers that the smallest and the largest code represent
    NumberExtent extent;
};

/// The result of a bake.
struct BakeSummary {
    // The outcome of the simulation. If the simulation failed, the frames before the failure were
    // still written, unless it failed while automatic ranges were fitted (bake_recorded).
    RunOutcome outcome;
    // The files that were written or kept, in the order of BakeOptions::frames.
    std::vector<std::filesystem::path> files;
    // One element per map or packing of which a file with WrittenFile::numbers was written, in any
    // order; empty if the files store floating-point numbers instead of codes.
    std::vector<WrittenNumbers> numbers;
    int kept = 0;  // number of frames whose existing files were kept; set by bake_recorded
};

/// A frame whose files have been written.
struct BakedFrame {
    SimulatedFrame shown;
    std::vector<WrittenFile> files;
    double seconds = 0.0;           // wall time of drawing, encoding, writing and measuring
    std::string measurements = {};  // result of measurements_json
};

/// Callbacks of a running bake; each may be empty.
///
/// - `on_frame` is called for each frame before it is drawn or kept, in the order in which the
///   source passes the frames (FrameAssembly).
/// - `on_baked` is called after the files of a frame have been written, in any order of frames, by
///   one thread at a time.
/// - `on_progress` receives the phases of the source, then the phase Frames, which counts written
///   frames. From bake_recorded it also receives the phase Ranges.
///
/// `on_baked` and `on_progress` may be called from another thread while `on_frame` runs.
struct BakeCallbacks {
    ProgressCallback on_progress = {};
    FrameVisitor on_frame = {};
    std::function<void(const BakedFrame&)> on_baked = {};
};

/// Checks the arguments of a bake. Throws std::invalid_argument in these cases:
///
/// - There are no frames, or a frame number is below 1.
/// - The file pattern is malformed, or would give two images the same file.
/// - The format of the files cannot store the primaries or a packing of the preset.
/// - The manifest would become too large (check_measurements).
///
/// Also throws as check_vector_files and check_file_words do. Throws OutputError if the files of
/// the first frame in `options.frames` cannot be written into their folders.
void check_bake(const Preset& preset, const BakeOptions& options);

/// Takes the frames from their source, draws them, and writes all maps of each frame. Creates
/// missing folders. Throws the exceptions of the source and of the callbacks. Throws OutputError if
/// a file cannot be written. Precondition: check_bake does not throw.
BakeSummary bake(const Preset& preset,
                 const BakeOptions& options,
                 const BakeCallbacks& callbacks = {});

}  // namespace foam::texgen
