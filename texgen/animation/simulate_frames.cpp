// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulate_frames.h"

#include "core/files/file_io.h"
#include "core/foam/measure.h"
#include "core/foam/stress.h"
#include "core/io/format_error.h"
#include "texgen/animation/display_transform.h"
#include "texgen/animation/loop_start.h"
#include "texgen/animation/seconds_since.h"
#include "texgen/animation/shown_states.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

// States are passed on as soon as they exist and are not kept here. A boil whose start is not known
// is simulated twice. The first simulation searches for the start, and stops when it has found it.
// The second simulation begins with the start, which was written as text and read again. It is
// therefore in the same situation as a simulation whose start was stored earlier. Apart from this
// text, nothing that the search leaves behind, such as its history (history.h), reaches the second
// simulation. Its frames are therefore the same in both cases. All other animations are simulated
// once. The frames of a breathe or shear loop continue from the foam whose cycle has closed. The
// method is our own.

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

bool advance(Simulation& simulation, FrameEffort& effort) {
    const Clock::time_point begin = Clock::now();
    const bool reached = simulation.advance();
    const EquilibriumSummary& equilibrium = simulation.equilibrium();
    effort.t1 += equilibrium.t1;
    effort.t2 += equilibrium.t2;
    effort.area_error = equilibrium.area_error;
    effort.angle_error = equilibrium.angle_error;
    effort.seconds += seconds_since(begin);
    effort.events.insert(
        effort.events.end(), simulation.events().begin(), simulation.events().end());
    return reached;
}

// Returns the mean stress of the simulated foam. `frame` shows this foam. If the loop has a display
// transform, `frame` shows the foam displaced or with the shear removed. The stress of `frame` may
// then differ.
Mat2 stress_of(const Simulation& simulation, const LoopOptions& loop, const Frame& frame) {
    if (has_display_transform(loop)) {
        return mean_stress(snapshot(simulation.foam(), simulation.number()));
    }
    return mean_stress(frame);
}

SimulatedFrame state_of(const Simulation& simulation, const LoopOptions& loop, FrameEffort effort) {
    SimulatedFrame state;
    state.frame = std::make_shared<const Frame>(simulation.frame());
    state.record = std::make_shared<const FoamRecord>(simulation.record());
    effort.strain = simulation.strain();
    effort.energy = energy(simulation.foam());
    effort.stress = stress_of(simulation, loop, *state.frame);
    state.effort = std::move(effort);
    state.view = simulation.view();
    state.closing_error = simulation.closing_error();
    return state;
}

// Stands in place of a file name in error messages about a start of a loop that was not compiled
// into the program.
constexpr const char* kKeptLoop = "the start of the loop";

// Returns the start of the loop of a preset that is stored in the program or, for a boil, kept in
// `memory`. Returns nullopt if there is none, or if the text in `memory` is damaged.
std::optional<LoopStart> known_loop_start(const Preset& preset, const LoopMemory& memory) {
    if (auto start = stored_loop_start(preset)) {
        return start;
    }
    if (preset.loop.kind != LoopKind::Boil) {
        return std::nullopt;
    }
    try {
        return matching_loop_start(preset, memory.content, kKeptLoop);
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const FormatError&) {
        return std::nullopt;
    }
}

RunOutcome failed(const Simulation& simulation, const Preset& preset) {
    return {simulation.equilibrium().converged() ? RunStatus::OpenLoop : RunStatus::NoEquilibrium,
            frame_of_state(simulation.number(), preset.loop, preset.frames.count),
            simulation.closing_error(),
            simulation.relaxations(),
            simulation.missing_bubbles()};
}

// Returns why a loop did not close. `closing_error` compares the foam at the start and at the end
// of the last cycle. It is infinite if a bubble is missing in one of the two states, or if its
// number of sides differs between them.
std::string open_loop_failure(double closing_error) {
    if (!std::isfinite(closing_error)) {
        return "the loop does not close: at the end of its last cycle, bubbles are missing or have "
               "other neighbors than at its start";
    }
    if (closing_error < Simulation::kClosed) {
        return "the loop does not close: the foam returned to its start in the last cycle, but a "
               "boil must do so in two cycles in a row, with the births at the same places";
    }
    return fmt::format(
        "the loop does not close: at the end of its last cycle, bubbles are up to {:.2g} mean "
        "bubble diameters away from their positions at its start",
        closing_error);
}

}  // namespace

std::string failure_of(const RunOutcome& outcome) {
    switch (outcome.status) {
        case RunStatus::NoEquilibrium:
            return fmt::format("frame {}: the foam did not reach equilibrium",
                               outcome.failed_frame);
        case RunStatus::OpenLoop:
            return open_loop_failure(*outcome.closing_error);
        case RunStatus::Complete:
            break;
    }
    return "";
}

FrameSource simulation_of(const Preset& preset, int threads) {
    return [preset, threads](const std::vector<int>& numbers,
                             NextFrames next_frames,
                             const FrameVisitor& on_frame,
                             const ProgressCallback& on_progress) {
        return simulate_frames(preset, threads, numbers, next_frames, on_frame, on_progress);
    };
}

RunOutcome simulate_states(const Preset& preset,
                           int threads,
                           const std::vector<int>& states,
                           const FrameVisitor& on_state,
                           const ProgressCallback& on_progress,
                           const LoopMemory& memory) {
    int cycles = 0;  // number of the last cycle that was reported
    const ProgressCallback report = [&](const RunProgress& progress) {
        cycles = progress.cycle;
        if (on_progress) {
            on_progress(progress);
        }
    };
    report({.phase = Phase::Seeding});
    std::optional<LoopStart> start = known_loop_start(preset, memory);
    if (!start && preset.loop.kind == LoopKind::Boil) {
        Simulation search(preset, threads, report);
        if (!search.advance()) {
            return failed(search, preset);
        }
        const std::string text = write_loop_start(search.loop_start(), loop_hash(preset));
        if (memory.keep) {
            memory.keep(text);
        }
        start = read_loop_start(text, kKeptLoop);
    }
    const ProgressCallback report_further = [&, searched = cycles](RunProgress progress) {
        progress.cycle += progress.phase == Phase::LoopClosing ? searched : 0;
        report(progress);
    };
    Simulation simulation = start ? Simulation(preset, std::move(*start), threads, report_further)
                                  : Simulation(preset, threads, report);
    for (const int number : states) {
        FrameEffort effort;
        while (simulation.number() < number) {
            if (simulation.number() > 0) {
                report({.phase = Phase::States,
                        .done = simulation.number(),
                        .total = states.back(),
                        .bubbles = simulation.bubble_count()});
            }
            if (!advance(simulation, effort)) {
                return failed(simulation, preset);
            }
        }
        on_state(state_of(simulation, preset.loop, std::move(effort)));
    }
    return {RunStatus::Complete,
            0,
            simulation.closing_error(),
            simulation.relaxations(),
            simulation.missing_bubbles()};
}

RunOutcome simulate_frames(const Preset& preset,
                           int threads,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame,
                           const ProgressCallback& on_progress) {
    FrameAssembly assembly(preset, numbers, next_frames, on_frame);
    const auto add = [&](const SimulatedFrame& state) { assembly.add(state); };
    return simulate_states(preset, threads, assembly.states(), add, on_progress);
}

}  // namespace foam::texgen
