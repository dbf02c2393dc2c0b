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

/// Which frames of a preset are baked, and how. None of it changes a pixel.
struct BakeOptions {
    std::vector<int> frames;   // numbers from 1, in any order, each once
    int threads = 0;           // 0: one per hardware thread
    FrameSource source = {};   // of the same preset; empty: its simulation
    std::set<int> there = {};  // of the frames, those whose files are there and stay as they are
};

struct BakeSummary {
    RunOutcome outcome;  // the frames before one that failed were written
    // Written, or there before, in the order of the frames asked for.
    std::vector<std::filesystem::path> files;
    int kept = 0;  // frames whose files were there
};

/// A frame whose files have been written.
struct BakedFrame {
    SimulatedFrame shown;
    std::vector<WrittenFile> files;
    double seconds = 0.0;  // of drawing, encoding and writing
};

/// What is told of a bake while it runs; any of them may be empty. `on_frame` is called before a
/// frame is drawn, in the order of simulate_frames; the others after it has been written, in any
/// order. None is called from two threads at once.
struct BakeCallbacks {
    ProgressCallback on_progress = {};
    FrameVisitor on_frame = {};
    std::function<void(const BakedFrame&)> on_baked = {};
};

/// Throws std::invalid_argument for options out of range and a pattern under which two images would
/// share a file.
void check_bake(const Preset& preset, const BakeOptions& options);

/// Takes the frames from their source, draws the frames and writes every map of each; folders are
/// made as needed. Throws as check_bake, and OutputError where a file cannot be written.
BakeSummary bake(const Preset& preset,
                 const BakeOptions& options,
                 const BakeCallbacks& callbacks = {});

}  // namespace foam::texgen
