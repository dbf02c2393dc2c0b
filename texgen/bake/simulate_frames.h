#pragma once

#include "core/foam/frame.h"
#include "texgen/bake/simulation.h"
#include "texgen/maps/foam_record.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace foam::texgen {

/// What it took to come to a frame from the frame handed out before it, or from the seed.
struct FrameEffort {
    int t1 = 0;
    int t2 = 0;
    double area_error = 0.0;   // of the frame: largest |A / A_target - 1| (E2)
    double angle_error = 0.0;  // of the frame: largest deviation from 120 degrees (E2), radians
    double seconds = 0.0;      // wall time of the steps
};

/// A frame with all that is drawn or measured of it.
struct SimulatedFrame {
    std::shared_ptr<const Frame> frame;
    FrameEffort effort;
    std::shared_ptr<const FoamRecord> record;
    std::shared_ptr<const Frame> next;         // the frame after it, where asked for
    std::optional<View> view = {};             // what images of a patch show, in all frames
    std::optional<double> closing_error = {};  // of a loop (Simulation::closing_error)
};

using FrameVisitor = std::function<void(const SimulatedFrame&)>;

/// Whether frames come with those after them, for which the simulation goes on by one frame beyond
/// the last.
enum class NextFrames { LeftOut, HandedOut };

enum class RunStatus {
    Complete,
    NoEquilibrium,
    OpenLoop,  // no frame was handed out
};

/// How a run ended.
struct RunOutcome {
    RunStatus status = RunStatus::Complete;
    int failed_frame = 0;                 // whose foam found no equilibrium, or whose loop is open
    std::optional<double> closing_error;  // of a loop (Simulation::closing_error)
};

/// Where frames come from: hands out those of these numbers, as simulate_frames does.
using FrameSource = std::function<RunOutcome(
    const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor&)>;

/// A simulation of a preset from its seed, each time it is asked.
FrameSource simulation_of(const Preset& preset, int threads);

/// Runs a simulation that has not begun to the last of the frames, and hands out each of them as
/// soon as it can: in increasing order, but in a pingpong, where a frame is shown on both ways, in
/// the order in which the simulation comes by.
RunOutcome simulate_frames(Simulation& simulation,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame);

}  // namespace foam::texgen
