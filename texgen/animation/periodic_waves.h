// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// A plane wave on a torus, cos(2 pi (across x + up y) + phase). The position (x, y) is given in
/// fractions of the width and height of the torus. `across` is the number of wavelengths in the
/// width, `up` the number in the height. Both are whole, so that the wave has no seam.
struct PeriodicWave {
    int across = 0;
    int up = 0;
    double phase = 0.0;  // radians

    friend bool operator==(const PeriodicWave&, const PeriodicWave&) = default;
};

/// The options of periodic_waves.
struct WaveOptions {
    int count = 1;           // number of waves that periodic_waves returns
    double number = 1.0;     // typical number of wavelengths in the shorter side of the torus
    double variation = 0.0;  // multiplies `number` by a random factor in 1 ± variation, per wave
    double aspect = 1.0;     // width of the torus divided by its height
    std::uint64_t seed = 1;
};

/// Returns waves with random phases. Half a turn is divided into as many equal sectors as there are
/// waves, and each wave has a random direction in its own sector. No wave is constant.
std::vector<PeriodicWave> periodic_waves(const WaveOptions& options);

}  // namespace foam::texgen
