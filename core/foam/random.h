#pragma once

#include <cstdint>
#include <random>

namespace foam {

/// Random numbers that are the same on every platform: the engine's bits are fixed by the C++
/// standard, and their mapping to reals is our own, since the standard distributions differ between
/// libraries.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1), a multiple of 2^-53.
    double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

    /// Uniform in {0, ..., bound - 1}, for bounds far below 2^53.
    std::uint64_t below(std::uint64_t bound) {
        return static_cast<std::uint64_t>(uniform() * static_cast<double>(bound));
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace foam
