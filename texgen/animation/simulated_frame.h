// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/foam_record.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace foam::texgen {

/// The effort of simulating a frame, and measurements of the foam. The effort covers the steps
/// since the previous frame that was passed to the FrameVisitor. For the first such frame, it
/// covers all steps since the start of the simulation, but not the search for the start of a boil
/// (simulate_states). From a cache with SkippedEfforts::Ignored (cache/cache.h), the steps to
/// states that are not read are left out. The measurements describe the state of the simulation
/// that the frame shows, before transformed_for_display (display_transform.h) changes it and before
/// a Current (current.h) displaces it.
struct FrameEffort {
    std::int64_t t1 = 0;                  // number of T1s
    std::int64_t t2 = 0;                  // number of T2s
    double area_error = 0.0;              // largest |A / A_target - 1| (E2)
    double angle_error = 0.0;             // largest deviation from 120 degrees (E2), radians
    double seconds = 0.0;                 // wall time of the simulation
    std::vector<TopologyEvent> events{};  // all T1s, T2s and births, in the order of time
    double strain = 0.0;                  // Simulation::strain
    double energy = 0.0;                  // film tension times total length of the films
    Mat2 stress{Mat2::Zero()};            // mean stress (E11)
};

/// A frame of the foam with everything that the maps need to draw it.
struct DrawnState {
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const FoamRecord> record;
    std::shared_ptr<const Frame> next;  // the frame after `frame`; null if not requested
    // Frame 1 of the animation, shared by all frames. Set by FrameAssembly; null in a state that
    // simulate_states passes.
    std::shared_ptr<const FrameOne> first;
    std::vector<double> fade_ranks = {};  // FadeOrder::ranks; empty unless loop.kind is "flow"

    /// Returns the input of FrameLayers, which borrows this state and the cross-fade. `distance`
    /// lists the images of the distance field that the maps need.
    FrameInput input(const DistanceNeeds& distance, const CrossFade* fade = nullptr) const {
        return {*frame, *record, next.get(), distance, fade, first.get()};
    }
};

/// A frame of an animation, or a state of the simulation, with all data for its images and its
/// statistics.
struct SimulatedFrame : DrawnState {
    FrameEffort effort;
    std::optional<View> view = {};             // view of a patch, the same in all frames
    std::optional<double> closing_error = {};  // Simulation::closing_error
    DrawnState fading_in = {};             // state that fades in; null pointers if there is none
    std::vector<double> fade_growth = {};  // how far each bubble of `fading_in` has grown, 0 to 1

    /// Returns the cross-fade, which borrows the frames; nullopt if there is none.
    std::optional<CrossFade> cross_fade() const {
        return fading_in.frame ? std::optional(CrossFade{*frame, *fading_in.frame, fade_growth})
                               : std::nullopt;
    }
};

/// Receives each frame of a run, one at a time.
using FrameVisitor = std::function<void(const SimulatedFrame&)>;

}  // namespace foam::texgen
