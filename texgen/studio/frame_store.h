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

namespace foam::texgen {

struct FrameRun;

/// Reports that a frame will not be simulated, because its simulation was stopped. The message
/// gives the reason: the page has asked for another foam, a foam that was asked for later has
/// replaced this foam, or the studio ends.
class SimulationStopped : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports that a frame cannot be simulated. The message gives the reason.
class SimulationFailed : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// The progress of the simulation of a preset.
struct SimulationState {
    enum class Status { Running, Complete, Failed };

    Status status = Status::Running;
    int done = 0;                              // frames 1 to this number can be drawn
    int total = 0;                             // frames 1 to this number will be kept
    RunProgress progress;                      // the latest report of the simulation
    std::optional<double> closing_error = {};  // RunOutcome::closing_error, if complete
    std::string message = {};                  // the reason of a failure
};

/// Simulates presets in the background, one at a time, and keeps the states of their foams, so that
/// any frame can be drawn immediately, with any colors. Each page of the studio wants one foam.
/// When a simulation ends, the next one is that of the foam that was wanted last among those not
/// simulated yet. A simulation that no page wants any more is stopped. At most eight foams are
/// kept, or fewer if the memory does not suffice. Foams whose simulation has ended (complete or
/// failed) are forgotten before foams whose simulation has not. In each of these two groups, the
/// foam that was wanted longest ago is forgotten first. Thread-safe.
class FrameStore {
  public:
    /// Keeps states of at most `bytes` bytes, approximately. If the states of an animation need
    /// more memory, only its first frames are kept, at least one. Also keeps at most 48 drafts (see
    /// `draft`), which use at most a quarter of `bytes`; the newest draft is always kept.
    explicit FrameStore(std::size_t bytes);
    ~FrameStore();
    FrameStore(const FrameStore&) = delete;
    FrameStore& operator=(const FrameStore&) = delete;

    /// Makes the foam of a preset the one that a page wants, and returns the progress of its
    /// simulation. `page` identifies the page: a random word (REQUESTS.md).
    SimulationState want(const Preset& preset, const std::string& page);

    /// Does what `want` does, waits until a frame can be drawn, and returns this frame. With
    /// NextFrames::Included, the result also contains the next frame. The view of a patch follows
    /// the image size and the camera of the given preset. This holds even if the kept states were
    /// simulated for a preset with another image size or camera. Throws SimulationStopped. Throws
    /// SimulationFailed if the foam has no equilibrium, the loop does not close, or the frame is
    /// not kept.
    SimulatedFrame frame(const Preset& preset,
                         int number,
                         NextFrames next_frames,
                         const std::string& page);

    /// Returns a draft of frame 1: the frame without the warm-up, the events and the loop, which
    /// can take much longer. It shows the seeded foam in equilibrium or, if the preset has
    /// FirstFrame::Diagram, before its first equilibration. Throws SimulationFailed.
    SimulatedFrame draft(const Preset& preset);

    /// Returns a source of the kept frames of a preset, which reports no progress. If all frames
    /// are kept, but their simulation has not ended yet, waits for its end. Returns an empty
    /// function unless all frames are kept and their simulation was successful.
    FrameSource source(const Preset& preset);

    /// Stops all simulations except drafts. Calls of `frame` that are waiting throw
    /// SimulationStopped, and so do later calls, unless the frame is not kept (SimulationFailed).
    void stop();

  private:
    using RunPointer = std::shared_ptr<FrameRun>;

    struct Draft {
        std::string simulation;  // simulation_hash of the preset of the draft
        std::size_t bytes = 0;   // its memory, approximately
        SimulatedFrame frame;
    };

    RunPointer new_run(const Preset& preset, const std::string& simulation) const;
    RunPointer want_run(const Preset& preset, const std::string& page);
    RunPointer next_run() const;
    SimulationState state_of(const FrameRun& run) const;
    void simulate(const RunPointer& run);
    void work();
    void forget_old_runs();
    void forget_old_drafts();

    std::size_t bytes_;
    std::mutex mutex_;  // protects all members below
    std::condition_variable changed_;
    std::list<RunPointer> runs_;  // the run that was wanted last is first
    std::list<Draft> drafts_;     // the newest is first
    bool is_stopped_ = false;
    std::thread worker_;  // the last member, because its thread uses the others
};

}  // namespace foam::texgen
