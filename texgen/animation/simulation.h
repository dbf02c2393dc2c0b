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

/// The foam of a preset, from its seed through its frames in order.
class Simulation {
  public:
    /// The foam is seeded here, and seeded_foam's exceptions come from here. The bits are the same
    /// for any number of threads; 0 are as many as the machine runs at once.
    explicit Simulation(const Preset& preset, int threads = 0);

    /// Goes on to the next frame: to frame 1 by equilibrium and the warm-up (to frame 2, where
    /// frame 1 shows the diagram), and by as many cycles as a loop takes to close; from frame to
    /// frame by a time step and the events of the preset, or by a step of the loop. A flow has new
    /// bubbles for those that vanished, in its warm-up too. False where no equilibrium is found, or
    /// the loop stays open; the foam is then of no more use.
    bool advance();

    /// Returns the frame that was reached. An animation shows some of them (shown_states).
    Frame frame() const;

    /// Returns the distance from the end of a cycle to its start, in diameters of a mean bubble
    /// (closing_error); nothing if no loop was tried.
    const std::optional<double>& closing_error() const { return closing_error_; }

    /// Returns the view of a patch, from frame 1 on; nothing for a torus.
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
    bool settle();  // equilibrium and the warm-up
    bool warm_up();
    bool close_loop();
    bool step_cycle(int place);
    double passed() const;  // of a loop, the part of it before the frame that was reached
    void add_effort(const EquilibriumSummary& before);
    bool step_by(double time, const StateChange& change);  // adds to what equilibrium_ counts

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
