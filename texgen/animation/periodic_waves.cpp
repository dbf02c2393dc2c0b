// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/periodic_waves.h"

#include "core/foam/random.h"
#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {

std::vector<PeriodicWave> periodic_waves(const WaveOptions& options) {
    Random random(options.seed);
    const double wide = std::max(options.aspect, 1.0);
    const double high = std::max(1.0 / options.aspect, 1.0);
    std::vector<PeriodicWave> waves;
    for (int k = 0; k < options.count; ++k) {
        // Opposite directions give the same wave, so half a turn contains all directions.
        const double direction = std::numbers::pi * (k + random.uniform()) / options.count;
        const double number =
            options.number * (1.0 + options.variation * (2.0 * random.uniform() - 1.0));
        PeriodicWave wave{static_cast<int>(std::lround(wide * number * ieee::cos(direction))),
                          static_cast<int>(std::lround(high * number * ieee::sin(direction))),
                          2.0 * std::numbers::pi * random.uniform()};
        if (wave.across == 0 && wave.up == 0) {
            (options.aspect >= 1.0 ? wave.across : wave.up) = 1;
        }
        waves.push_back(wave);
    }
    return waves;
}

}  // namespace foam::texgen
