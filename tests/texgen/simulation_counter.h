// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"

namespace foam::texgen {

/// Counts how often a foam is simulated from its seed, by the reports of the progress.
class SimulationCounter {
  public:
    /// Returns a callback that counts. Borrows this object.
    ProgressCallback callback() {
        return [this](const RunProgress& progress) {
            count_ += progress.phase == Phase::Equilibrium && last_ != Phase::Equilibrium ? 1 : 0;
            last_ = progress.phase;
        };
    }

    int count() const { return count_; }

  private:
    int count_ = 0;
    Phase last_ = Phase::Frames;
};

}  // namespace foam::texgen
