// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle.h"
#include "core/dynamics/step.h"
#include "core/foam/frame.h"
#include "texgen/animation/camera.h"
#include "texgen/animation/history.h"
#include "texgen/animation/timeline.h"
#include "texgen/preset/preset.h"

#include <optional>

namespace foam::texgen {

/// Simulates the foam of a preset from its seed, one frame after the other.
class Simulation {
  public:
    /// Seeds the foam. Throws as seeded_foam does. The results are the same to the last bit for
    /// any number of threads; 0 uses all hardware threads.
    explicit Simulation(const Preset& preset, int threads = 0);

    /// Advances to the next frame. Before frame 1 the foam is equilibrated and warmed up (before
    /// frame 2 if frame 1 shows the diagram), and a periodic loop runs cycles until it closes. Each
    /// later frame takes one time step with the events of the preset, or one step of the loop. In a
    /// flow, new bubbles replace bubbles that have vanished, also in the warm-up. Returns false if
    /// no equilibrium is found or the loop does not close; the foam must not be used after that.
    bool advance();

    /// Returns the frame that was reached. An animation shows some frames of the simulation
    /// (shown_states).
    Frame frame() const;

    /// Returns the distance between the states at the start and at the end of the last cycle, in
    /// diameters of a mean bubble (closing_error in core/dynamics/cycle.h); nullopt if no cycle was
    /// run.
    const std::optional<double>& closing_error() const { return closing_error_; }

    /// Returns the view of a patch, from frame 1 on; nullopt for a torus.
    const std::optional<View>& view() const { return view_; }

    /// Returns the record that the maps of this frame need.
    FoamRecord record() const;

    /// Returns the number of the frame that was reached; 0 before the first.
    int number() const { return number_; }

    /// Returns the effort and the accuracy of the last advance.
    const EquilibriumSummary& equilibrium() const { return equilibrium_; }

  private:
    bool reach_frame();
    bool reach_first_frame();
    void measure_diagram();
    bool equilibrate_and_warm_up();
    bool warm_up();
    bool close_loop();
    bool step_cycle(int position);
    double passed() const;  // fraction of the loop before the frame that was reached
    void add_effort(const EquilibriumSummary& before);
    bool step_by(double time, const StateChange& change);  // adds its effort to equilibrium_

    FramesOptions frames_;
    LoopOptions loop_;
    ImageOptions image_;
    CameraOptions camera_;
    double next_step_;  // foam time to the next frame
    StepOptions options_;
    Foam foam_;
    Timeline timeline_;
    History history_;
    std::uint64_t seed_;
    std::optional<Cycle> cycle_;
    std::optional<double> closing_error_;
    std::optional<View> view_;
    int number_ = 0;
    EquilibriumSummary equilibrium_;
};

}  // namespace foam::texgen
