// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cache/cache_files.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// A read-only view of a folder with the states of a simulation, one file per state. Frames can be
/// drawn from the states on any machine. Many programs may read a folder at once, also while a
/// simulation still adds states.
class Cache {
  public:
    /// Opens a cache. Throws InputError if the folder is not a cache, if its file format is newer
    /// than this program, or if its file of pressures is damaged.
    explicit Cache(std::filesystem::path folder);

    const CacheInfo& info() const { return info_; }

    /// Returns the state with the given number. Throws InputError if it is missing or damaged.
    SimulatedFrame state(int number) const;

    /// Returns a source of frames. The frames equal those of a simulation of the preset to the last
    /// bit. Precondition: the preset differs from the preset of the cache only in keys that change
    /// no state (check_same_simulation). The source borrows the cache.
    FrameSource frames_of(const Preset& preset) const;

  private:
    std::filesystem::path folder_;
    CacheInfo info_;
    std::vector<double> first_pressures_;
};

/// Simulates a preset and writes the states that the frames need to a cache, including the state
/// after each frame, which maps such as motion need. Uses only `frames` and `threads` of the
/// options. Creates the folder if necessary and overwrites files of an existing cache. Throws
/// std::invalid_argument if there are no frames or one is below 1, OutputError if a file cannot be
/// written, and the exceptions of Simulation.
RunOutcome simulate_into_cache(const Preset& preset,
                               const BakeOptions& options,
                               const std::filesystem::path& folder,
                               const ProgressCallback& on_progress);

}  // namespace foam::texgen
