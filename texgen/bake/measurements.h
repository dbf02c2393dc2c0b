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
///   foamtex::Bubble.
/// - events: the T1s, T2s and births of FrameEffort::events, as objects.
/// - shear_modulus: a number, or null if the frame has none (core/dynamics/shear_modulus.h).
///
/// Bubbles and the shear modulus are those of the frame as it is shown. In a shear loop, and with a
/// current, it is displaced; it then has no shear modulus, and its positions are not those of
/// events.
/// Lengths are in foam units. A number that is not finite becomes null.
std::string measurements_json(const SimulatedFrame& shown,
                              std::span<const std::string> measurements);

/// Returns true if the text, which measurements_json has returned, has a member for each word of
/// `measurements`.
bool contains(const std::string& text, std::span<const std::string> measurements);

}  // namespace foam::texgen
