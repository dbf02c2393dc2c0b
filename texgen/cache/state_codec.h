// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/animation/simulate_frames.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// Encodes a state: the frame, the effort of its simulation (FrameEffort), and the record of
/// earlier frames that maps need (FoamRecord). The view and the closing error are not encoded;
/// Cache::frames_of sets them. If FoamRecord::first_pressures, the pressures at the end of the
/// warm-up, equal the argument `first_pressures` and are not empty, they are left out. The values
/// that the record has for bubbles that have vanished are also left out, because no map needs them.
Bytes pack_state(const SimulatedFrame& state, const std::vector<double>& first_pressures);

/// Decodes a state. Maps drawn from the decoded state have the same bits as maps drawn from the
/// original state. `first_pressures` becomes FoamRecord::first_pressures if pack_state has left out
/// these pressures. Throws BadContent if the bytes are not a state, or if `first_pressures` is
/// needed but empty.
SimulatedFrame unpack_state(std::span<const std::byte> content,
                            const std::vector<double>& first_pressures);

/// Encode and decode a list of numbers. `unpack_numbers` throws BadContent if the bytes end too
/// early, or if a number is not finite or too large (is_plausible in frame_check.h).
Bytes pack_numbers(const std::vector<double>& numbers);
std::vector<double> unpack_numbers(std::span<const std::byte> content);

}  // namespace foam::texgen
