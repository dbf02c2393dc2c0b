// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/foam_record.h"
#include "texgen/raster/coords/raster_grid.h"

#include <functional>
#include <memory>
#include <optional>

namespace foam::texgen {

/// The effort to reach a frame from the frame handed out before it, or from the seed, and the
/// errors of the frame.
struct FrameEffort {
    int t1 = 0;
    int t2 = 0;
    double area_error = 0.0;   // largest |A / A_target - 1| (E2)
    double angle_error = 0.0;  // largest deviation from 120 degrees (E2), radians
    double seconds = 0.0;      // wall time of the steps
};

/// A frame of the foam with everything that the maps need to draw it.
struct DrawnState {
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const FoamRecord> record;
    std::shared_ptr<const Frame> next;  // the frame after it; null if not requested
};

/// A frame of an animation, or a state of the simulation, with all data for its images and its
/// statistics.
struct SimulatedFrame : DrawnState {
    FrameEffort effort;
    std::optional<View> view = {};             // of a patch; the same in all frames
    std::optional<double> closing_error = {};  // of a loop (Simulation::closing_error)
    DrawnState rising = {};                    // in a cross-fade, the state that fades in
    double faded = 0.0;                        // fraction of the fade that has passed, 0 to 1
};

using FrameVisitor = std::function<void(const SimulatedFrame&)>;

}  // namespace foam::texgen
