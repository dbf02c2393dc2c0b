// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <foamtex/texture.h>

#include <memory>
#include <mutex>
#include <utility>

namespace foamtex {

struct Preset::State {
    foam::texgen::Preset preset;
    bool has_fitted_ranges = false;  // true after Preset::fit_ranges
};

struct Frame::State {
    State(foam::texgen::SimulatedFrame frame, Preset simulation_preset)
        : simulated(std::move(frame)), preset(std::move(simulation_preset)) {}

    // The frame with its view, the statistics of the simulation (effort), and the frame after it.
    foam::texgen::SimulatedFrame simulated;
    Preset preset;  // the preset of the simulation
    // The records of the frame, which are computed when they are first needed.
    mutable std::once_flag has_records;
    mutable FoamRecords records;
};

}  // namespace foamtex
