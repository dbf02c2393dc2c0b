// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress_meter.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/bake/written_file.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <functional>
#include <set>
#include <vector>

namespace foam::texgen {

/// The frames to bake and how to compute them. No option changes a pixel.
struct BakeOptions {
    std::vector<int> frames;  // numbers from 1, in any order, each once
    int threads = 0;          // 0: one per hardware thread
    FrameSource source = {};  // source of the frames of the preset; if empty, it is simulated
    std::set<int> existing_frames = {};  // those of `frames` whose existing files are kept
};

struct BakeSummary {
    RunOutcome outcome;  // if the run failed, the frames handed out before were still written
    // The files that were written or kept, in the order of BakeOptions::frames.
    std::vector<std::filesystem::path> files;
    int kept = 0;  // number of frames whose existing files were kept; `bake` leaves it 0
};

/// A frame whose files have been written.
struct BakedFrame {
    SimulatedFrame shown;
    std::vector<WrittenFile> files;
    double seconds = 0.0;  // time of drawing, encoding and writing
};

/// Callbacks of a running bake; each may be empty. `on_frame` is called for each frame before it is
/// drawn or kept, in the order of simulate_frames. The others are called after a frame has been
/// written, in any order of frames. No callback is called from two threads at once.
struct BakeCallbacks {
    ProgressCallback on_progress = {};
    FrameVisitor on_frame = {};
    std::function<void(const BakedFrame&)> on_baked = {};
};

/// Throws std::invalid_argument if there are no frames, if one is below 1, or if the file pattern
/// would give two images the same file.
void check_bake(const Preset& preset, const BakeOptions& options);

/// Takes the frames from their source, draws them, and writes every map of each. Creates missing
/// folders. Throws the exceptions of check_bake and of the source, and OutputError if a file cannot
/// be written.
BakeSummary bake(const Preset& preset,
                 const BakeOptions& options,
                 const BakeCallbacks& callbacks = {});

}  // namespace foam::texgen
