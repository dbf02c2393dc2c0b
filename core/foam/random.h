// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <random>

namespace foam {

/// A generator of random numbers that are the same on every platform. The C++ standard specifies
/// the output of the engine. The mapping of this output to real numbers is implemented here,
/// because the results of the standard distributions differ between libraries.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Returns a uniform random number in [0, 1), a multiple of 2^-53.
    double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

    /// Returns a uniform random integer in {0, ..., bound - 1}. Precondition: the bound is far
    /// below 2^53, otherwise the integers are not equally likely.
    std::uint64_t below(std::uint64_t bound) {
        return static_cast<std::uint64_t>(uniform() * static_cast<double>(bound));
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace foam
