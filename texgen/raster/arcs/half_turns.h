#pragma once

#include <array>
#include <cstddef>

namespace foam::texgen {

/// Some angles in [-pi, pi], and their cosines and sines: by IEEE operations alone, to 1e-14.
struct HalfTurns {
    static constexpr std::size_t kLanes = 8;

    std::array<double, kLanes> angle{};
    std::array<double, kLanes> cosine{};
    std::array<double, kLanes> sine{};
};

/// Finds the cosines and sines, several at once.
void find_turns(HalfTurns& turns);

}  // namespace foam::texgen
