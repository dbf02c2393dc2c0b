// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/cache/cache_files.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Writes each state to a cache as soon as the state has been simulated. The folder and cache.json
/// are created only when the first state is written. A simulation that fails before its first state
/// therefore leaves no cache. It may only leave loop.json (README.md), which this class does not
/// write.
class CacheWriter {
  public:
    /// `frames` are the frames that can be drawn once all states have been written.
    CacheWriter(const Preset& preset, std::vector<int> frames, std::filesystem::path folder);

    /// Writes the file of a state, and pressures.foam before the first state that needs it. Throws
    /// OutputError if a file cannot be written.
    void write(const SimulatedFrame& state);

  private:
    void begin(const std::optional<double>& closing_error);

    CacheInfo info_;
    std::filesystem::path folder_;
    bool begun_ = false;
    std::vector<double> first_pressures_;
};

}  // namespace foam::texgen
