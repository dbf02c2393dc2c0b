// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace foam::texgen {

/// The files of a cache that store automatic ranges of maps (fit_automatic_ranges). The ranges of a
/// preset are thus fitted once, and not by every program that draws frames of the cache. There is
/// one file per map. Its name contains a hash of everything that influences the range:
/// - the simulation (simulation_hash)
/// - the frames to which the range is fitted
/// - the size of the images
/// - the keys in the tables that the map uses, and the keys of the camera
class StoredRanges {
  public:
    /// `preset` has automatic ranges that are not yet fitted, `frames` are the frames to which they
    /// are fitted, and `folder` is the folder of the cache.
    StoredRanges(const Preset& preset,
                 const std::vector<int>& frames,
                 const std::filesystem::path& folder);

    /// Sets all automatic ranges of the preset to the stored ranges. Returns false and changes
    /// nothing if one of them is not stored, or if its file is damaged.
    bool load(Preset& preset) const;

    /// Stores the automatic ranges of the preset, which have been fitted. If a file cannot be
    /// written, the remaining files are left out, without an error: a cache may be on a disk that
    /// is full or read-only.
    void save(const Preset& preset) const;

  private:
    std::map<std::string, std::filesystem::path> files_;  // indexed by map name
};

}  // namespace foam::texgen
