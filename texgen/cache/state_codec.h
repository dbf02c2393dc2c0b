#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/image/file_io.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The state of a frame: the foam as images show it, and what maps need to know of the frames
/// before. Of the record, the pressures of the first equilibrium are left out where they are those
/// given, and what belongs to bubbles that are gone; no map asks for it.
Bytes pack_state(const SimulatedFrame& state, const std::vector<double>& first_pressures);

/// Undoes it: every map is the same, to the last bit. Throws BadContent where it is none.
SimulatedFrame unpack_state(std::span<const std::byte> content,
                            const std::vector<double>& first_pressures);

/// Numbers alone.
Bytes pack_numbers(const std::vector<double>& numbers);
std::vector<double> unpack_numbers(std::span<const std::byte> content);

}  // namespace foam::texgen
