// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <optional>
#include <string>

namespace foam::texgen {

/// Returns true if a number is finite and its absolute value is at most 1e15. In foam units, all
/// numbers of a foam are far below this limit.
bool is_plausible(double number);

/// Checks the numbers of a frame from an untrusted source. Returns a description of the first
/// fault, or nullopt if there is none. Precondition: the network of the frame is valid. The rules
/// are:
///
/// - All numbers are plausible (is_plausible). Target areas and the film tension are positive.
/// - Each identity occurs once and is below kMaxIdentity. Lone bubbles are in the order of their
///   identities.
/// - The half angle of each film is between -pi and pi.
/// - The domain is the plane if there is a ghost bubble. Otherwise it is a torus whose sides have a
///   moderate ratio (has_moderate_shape). The absolute value of its shear is at most its width.
/// - On a torus, |x| of each junction is at most twice the width, and |y| is at most twice the
///   height. No film is longer than the width plus the height. Coordinates in pixels then stay
///   within the limits of the rasterizer.
std::optional<std::string> find_frame_fault(const Frame& frame);

}  // namespace foam::texgen
