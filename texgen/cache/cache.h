// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cache/cache_files.h"
#include "texgen/preset/preset.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace foam::texgen {

/// The states of a simulation that were stored, such as those of a Cache. Both functions are called
/// in increasing order of the numbers of states.
struct StoredStates {
    /// Returns the state with the given number.
    std::function<SimulatedFrame(int number)> state;
    /// Returns the effort of a state that no frame needs, so that the effort of the next frame
    /// includes it. Returns nullopt if there is no such state, or if efforts do not matter.
    std::function<std::optional<FrameEffort>(int number)> skipped_effort;
};

/// Returns a source of frames whose states were stored. The source sets the members `view` and
/// `closing_error` of the states, and reports the phase States.
FrameSource frames_from_states(const Preset& preset,
                               StoredStates stored,
                               std::optional<double> closing_error);

/// Decides whether the effort of a frame includes the efforts of the states between the previous
/// frame and this frame.
enum class SkippedEfforts {
    Ignored,
    Counted,  // each of these states is read, for the sake of its effort alone
};

/// A read-only view of a cache: a folder with the states of a simulation, one file per state.
/// Frames can be drawn from the states on any machine. Several programs may read the folder at
/// once, also while a simulation still adds states.
class Cache {
  public:
    /// Opens a cache. Throws InputError if cache.json is missing, malformed or of a newer version
    /// of the file format than this program supports.
    explicit Cache(std::filesystem::path folder);

    const CacheInfo& info() const { return info_; }

    /// Returns the state with the given number. Its members `view` and `closing_error` are not set.
    /// Throws InputError if its file is missing or damaged. Also throws it if the file of pressures
    /// is damaged, or is missing although the state needs it.
    SimulatedFrame state(int number) const;

    /// Returns a source of frames. The frames equal, to the last bit, the frames of a simulation of
    /// the preset by the version of foamtex that wrote the cache, except for FrameEffort if skipped
    /// efforts are ignored. The source throws InputError if a state that it reads is missing or
    /// damaged. The source keeps a reference to the cache. Precondition: the preset differs from
    /// the preset of the cache only in keys that do not influence the states
    /// (check_same_simulation).
    FrameSource frames_of(const Preset& preset, SkippedEfforts skipped) const;

  private:
    std::vector<double> first_pressures() const;

    std::filesystem::path folder_;
    CacheInfo info_;
};

/// Returns the estimated size, in bytes, of the states that simulate_into_cache writes for the
/// given frames. States that exist in the folder are not counted.
std::uint64_t estimated_cache_size(const Preset& preset,
                                   const std::vector<int>& frames,
                                   const std::filesystem::path& folder);

/// Simulates a preset and writes into a cache the states that the frames need. Also writes the
/// state after each frame, because some maps, such as `motion`, need it. Uses only `frames` and
/// `threads` of the options. Creates the folder if necessary and overwrites files of an existing
/// cache. `on_progress` receives the phases of the simulation, and then the phase Frames, which
/// counts written states. If the simulation is complete, also fits the automatic ranges of the maps
/// of the preset, where this is possible, and stores them in the cache (StoredRanges);
/// `on_progress` then receives the phases States and Ranges. Throws std::invalid_argument if there
/// are no frames or a frame number is below 1, OutputError if a file cannot be written, and the
/// exceptions of Simulation.
RunOutcome simulate_into_cache(const Preset& preset,
                               const BakeOptions& options,
                               const std::filesystem::path& folder,
                               const ProgressCallback& on_progress);

}  // namespace foam::texgen
