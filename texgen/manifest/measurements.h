// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"

#include <span>
#include <string>

namespace foam::texgen {

/// Returns measurements of the foam in a frame as a JSON object on one line, or an empty text if
/// `measurements` is empty. Each word of `measurements` (OutputOptions::measurements) adds the
/// member of its name:
///
/// - bubbles: an object of lists with one number per bubble, which are named as the members of
///   foamtex::Bubble. The bubbles are those that the frame shows.
/// - events: the T1s, T2s and births of FrameEffort::events, as objects.
/// - shear_modulus: a number, or null if the frame has none (core/dynamics/shear_modulus.h).
///
/// Lengths are in foam units. A number that is not finite becomes null.
std::string measurements_json(const SimulatedFrame& shown,
                              std::span<const std::string> measurements);

}  // namespace foam::texgen
