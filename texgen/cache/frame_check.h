// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <optional>
#include <string>

namespace foam::texgen {

/// Returns true if a number of a state is finite and not larger than the numbers of a foam can be.
bool is_plausible(double number);

/// Checks the numbers of a frame from an untrusted source, whose network is valid. Returns a
/// description of the first fault, or nullopt if there is none. All numbers must be finite and
/// plausible. Areas must be positive. Each identity must occur once and be below kMaxIdentity. On a
/// torus, positions must be in the fundamental cell or at most one period beside it, and films must
/// not be longer than the width plus the height, so that coordinates in pixels stay within the
/// limits of the rasterizer.
std::optional<std::string> find_frame_fault(const Frame& frame);

}  // namespace foam::texgen
