// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// A plane wave on a torus, cos(2 pi (across x + up y) + phase), where x and y are fractions of the
/// torus. The numbers of waves across and up are whole, so that the wave has no seam.
struct PeriodicWave {
    int across = 0;
    int up = 0;
    double phase = 0.0;  // radians

    friend bool operator==(const PeriodicWave&, const PeriodicWave&) = default;
};

/// The options of periodic_waves.
struct WaveOptions {
    int count = 1;
    double number = 1.0;     // typical number of waves along the shorter side of the torus
    double variation = 0.0;  // of this number: fractions from 1 - variation to 1 + variation occur
    double aspect = 1.0;     // width of the torus divided by its height
    std::uint64_t seed = 1;
};

/// Returns waves with random phases. Their directions are random, but spread evenly. None of the
/// waves is constant.
std::vector<PeriodicWave> periodic_waves(const WaveOptions& options);

}  // namespace foam::texgen
