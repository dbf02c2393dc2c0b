// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <condition_variable>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace foam::texgen {

struct FrameRun;

/// Reports that a page no longer waits for a frame, because it has asked for another foam or the
/// studio ends.
class FrameReplaced : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports that a frame cannot be simulated. The message gives the reason.
class SimulationFailed : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// How far the simulation of a preset is.
struct SimulationState {
    enum class Status { Running, Complete, Failed };

    Status status = Status::Running;
    int done = 0;          // number of the first frames that are all kept
    int total = 0;         // number of frames that will be kept
    RunProgress progress;  // of the phase in work
    std::optional<double> closing_error = {};
    std::string message = {};  // the reason of a failure
};

/// Simulates presets in the background, one at a time, and keeps the states of their foams, so that
/// any frame can be drawn at once, with any colors. Each page of the studio wants one foam; the
/// foam that was wanted last is simulated first, and a simulation that no page wants any more is
/// stopped. Foams that are complete are kept as long as memory allows. Thread-safe.
class FrameStore {
  public:
    /// Keeps states of at most `bytes` bytes, approximately. Of a long animation of a large foam,
    /// only the first frames may be kept.
    explicit FrameStore(std::size_t bytes);
    ~FrameStore();
    FrameStore(const FrameStore&) = delete;
    FrameStore& operator=(const FrameStore&) = delete;

    /// Makes the foam of a preset the one that a page wants, and returns how far it is.
    SimulationState want(const Preset& preset, const std::string& page);

    /// Does what `want` does, waits until a frame can be drawn, and returns it, and the frame after
    /// it if `next_frames` asks for it. The options of the image, the camera and the loop are those
    /// of the given preset. Throws FrameReplaced, and SimulationFailed if the foam has no
    /// equilibrium, the loop does not close, or the frame is not kept.
    SimulatedFrame frame(const Preset& preset,
                         int number,
                         NextFrames next_frames,
                         const std::string& page);

    /// Returns a draft of frame 1: the seeded foam in equilibrium, without the warm-up, the events
    /// and the loop, which can take much longer. Throws SimulationFailed.
    SimulatedFrame draft(const Preset& preset);

    /// Returns a source of the kept frames of a preset; empty unless all of them are kept.
    FrameSource source(const Preset& preset);

    /// Stops all simulations. All functions that wait, now or later, throw FrameReplaced.
    void stop();

  private:
    using RunPointer = std::shared_ptr<FrameRun>;

    RunPointer new_run(const Preset& preset, const std::string& simulation) const;
    RunPointer want_run(const Preset& preset, const std::string& page);
    RunPointer next_run() const;
    SimulationState state_of(const FrameRun& run) const;
    void simulate(const RunPointer& run);
    void work();
    void forget_old_runs();

    std::size_t bytes_;
    std::mutex mutex_;  // protects all members below
    std::condition_variable changed_;
    std::list<RunPointer> runs_;  // the run that was wanted last is first
    std::list<std::pair<std::string, SimulatedFrame>> drafts_;  // by simulation, newest first
    bool is_stopped_ = false;
    std::thread worker_;  // the last member, because its thread uses the others
};

}  // namespace foam::texgen
