#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cache/cache_files.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// The states of a simulation in a folder, a file each, to draw frames of on any machine. Only
/// read; many programs may at once, also while a simulation still adds states.
class Cache {
  public:
    /// Throws InputError where the folder is no cache, or one of a newer file format.
    explicit Cache(std::filesystem::path folder);

    const CacheInfo& info() const { return info_; }

    /// Returns the state of the frame of this number. Throws InputError where it is missing or
    /// damaged.
    SimulatedFrame state(int number) const;

    /// Hands out frames as a simulation of the preset would, to the last bit. The preset is that of
    /// the cache but for what changes no state (check_same_simulation). Borrows the cache.
    FrameSource frames_of(const Preset& preset) const;

  private:
    std::filesystem::path folder_;
    CacheInfo info_;
    std::vector<double> first_pressures_;
};

/// Simulates the frames of a preset, and those after them that maps of motion need, into a cache;
/// the folder is made as needed. A cache that is there already is replaced. Throws as Simulation,
/// std::invalid_argument for frames below 1, and OutputError.
RunOutcome simulate_into_cache(const Preset& preset,
                               const BakeOptions& options,
                               const std::filesystem::path& folder,
                               const ProgressCallback& on_progress);

}  // namespace foam::texgen
