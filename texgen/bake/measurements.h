// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <cstddef>
#include <span>
#include <string>

namespace foam::texgen {

/// Returns measurements of the foam in a frame as a JSON object on one line, or an empty text if
/// `measurements` is empty. Each word of `measurements` (OutputOptions::measurements) adds the
/// member of its name:
///
/// - bubbles: an object with one list for each member of foamtex::Bubble. A list has the name of
///   its member and one number per bubble.
/// - events: the T1s, T2s and births of FrameEffort::events, as objects.
/// - shear_modulus: a number, or null if the frame has none (core/dynamics/shear_modulus.h).
///
/// Bubbles and the shear modulus are measured in the frame as it is shown; events are recorded
/// during the simulation. A drift, a current, a cross-fade and a shear loop displace the shown
/// foam, so that its positions do not match the positions of the events. Except for a drift, they
/// also disturb its equilibrium, so that it seldom has a shear modulus.
///
/// Lengths are in foam units. A number that is not finite becomes null.
std::string measurements_json(const SimulatedFrame& shown,
                              std::span<const std::string> measurements);

/// Returns true if `json`, a result of measurements_json, has a member for each word of
/// `measurements`.
bool has_measurements(const std::string& json, std::span<const std::string> measurements);

/// Checks before a bake that the manifest can hold the measurements of a number of frames. Throws
/// std::invalid_argument if the measurement `bubbles` of these frames would, by an estimate, make
/// the manifest larger than the program reads (kDescriptionInput.max_bytes).
void check_measurements(const Preset& preset, std::size_t frames);

}  // namespace foam::texgen
