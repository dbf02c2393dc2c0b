// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle.h"
#include "core/dynamics/step.h"
#include "core/foam/frame.h"
#include "texgen/animation/camera.h"
#include "texgen/animation/history.h"
#include "texgen/animation/loop_start.h"
#include "texgen/animation/progress.h"
#include "texgen/animation/timeline.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <vector>

namespace foam::texgen {

/// Simulates the foam of a preset, one frame after another. The frames of this class are the states
/// of shown_states.h: a frame of an animation shows one or two of them.
class Simulation {
  public:
    /// A cycle closes if its closing_error is below this number. In a boil (a loop of the kind
    /// "boil"), Cycle::repeats must return true, too.
    static constexpr double kClosed = 1e-9;

    /// Seeds the foam. `threads` is the number of threads, 0 for all hardware threads; the results
    /// have the same bits for any number of threads. `on_progress` receives the phases Equilibrium,
    /// WarmUp and LoopClosing. Throws the exceptions of seeded_foam.
    explicit Simulation(const Preset& preset, int threads = 0, ProgressCallback on_progress = {});

    /// Starts at a state from which the loop of the preset closes in one cycle (stored_loop_start),
    /// instead of seeding a foam. `on_progress` receives only the phase LoopClosing.
    Simulation(const Preset& preset,
               LoopStart start,
               int threads = 0,
               ProgressCallback on_progress = {});

    /// Advances to the next frame. Before frame 1, the foam is equilibrated and warmed up, that is,
    /// simulated for the time FramesOptions::warm_up. If frame 1 shows the raw diagram
    /// (FirstFrame::Diagram), this happens before frame 2 instead. Before frame 1 of a breathe,
    /// shear or boil loop, cycles are run until the loop closes. Each later frame takes one time
    /// step with the events of the preset. In a breathe, shear or boil loop it takes one step of
    /// the cycle instead, and in a drift loop no step. In a flow loop, new bubbles replace bubbles
    /// that have vanished, also in the warm-up. Returns false if no equilibrium is found or the
    /// loop does not close; the foam must not be used after that. Rethrows the exceptions of the
    /// callback.
    bool advance();

    /// Returns the frame that was reached, as images show it (display_transform.h), but without the
    /// current of the loop (current.h).
    Frame frame() const;

    /// Returns the distance between the states at the start and at the end of the last cycle before
    /// frame 1 (closing_error in core/dynamics/cycle.h). The unit is the diameter of a mean bubble.
    /// Returns nullopt if no cycle was run.
    const std::optional<double>& closing_error() const { return closing_error_; }

    /// Returns the state at frame 1 of a loop that has closed. Precondition: the loop is a breathe,
    /// shear or boil loop, and frame 1 was reached, but no later frame.
    LoopStart loop_start() const;

    /// Returns the view of a patch once frame 1 has been reached; nullopt for a torus.
    const std::optional<View>& view() const { return view_; }

    /// Returns the record that maps need to draw the frame that was reached.
    FoamRecord record() const;

    /// Returns the foam itself, in the state that was reached, without any transform for display.
    const Foam& foam() const { return foam_; }

    /// Returns the total strain by which this simulation has sheared the foam (E9). Unlike
    /// Domain::shear, it is not reduced by whole periods of the torus.
    double strain() const { return strain_; }

    /// Returns the topology events of the last advance(), in the order in which they happened. They
    /// include the events of the first equilibration, of the warm-up, and of the cycles that close
    /// a loop, if this call of advance() ran them.
    const std::vector<TopologyEvent>& events() const { return events_; }

    /// Returns the number of bubbles of the foam.
    int bubble_count() const;

    /// Returns, for each event of the preset, the number of missing bubbles. A bubble is missing if
    /// the event should have chosen or created it by now, but it did not exist or could not be
    /// created.
    std::vector<int> missing_bubbles() const { return timeline_.missing_bubbles(); }

    /// Returns the number of the frame that was reached; 0 before the first call of advance().
    int number() const { return number_; }

    /// Returns how often a step has relaxed the whole foam (EquilibriumSummary::relaxations). The
    /// relaxations during the first equilibration are not counted.
    int relaxations() const { return relaxations_; }

    /// Returns the effort of the last advance() and the errors of the frame that it reached.
    const EquilibriumSummary& equilibrium() const { return equilibrium_; }

  private:
    Simulation(const Preset& preset, Foam foam, int threads, ProgressCallback on_progress);

    bool reach_frame();
    bool reach_first_frame();
    void record_events(int frame);
    void measure_diagram();
    bool equilibrate_and_warm_up();
    bool warm_up();
    bool close_loop();
    bool step_cycle(int position);
    double loop_progress() const;  // fraction of the loop that precedes the present frame
    bool step_by(double time, const StateChange& change);
    bool add_step(const StepSummary& step);   // adds its effort; returns whether it converged
    void report(RunProgress progress) const;  // adds the number of bubbles

    FramesOptions frames_;
    LoopOptions loop_;
    ImageOptions image_;
    CameraOptions camera_;
    double next_step_;  // length of the step to the next frame, foam time
    StepOptions options_;
    CycleOptions cycle_options_;
    bool has_several_parts_;  // true if the outline of a patch has several parts
    Foam foam_;
    Timeline timeline_;
    History history_;
    ProgressCallback on_progress_;
    std::optional<Cycle> cycle_;  // set by close_loop or by the constructor from a LoopStart
    std::optional<double> closing_error_;
    std::optional<View> view_;
    int number_ = 0;
    double strain_ = 0.0;
    int relaxations_ = 0;
    std::vector<TopologyEvent> events_;  // of the last advance()
    EquilibriumSummary equilibrium_;
};

}  // namespace foam::texgen
