// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/scratch_folder.h"
#include "texgen/bake/bake.h"
#include "texgen/cache/cache.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <vector>

namespace foam::texgen {

/// One simulation for several bakes of a preset, for example in several sizes. The foam is
/// simulated when a frame is first requested. Its states are stored in a cache in the system's
/// folder for temporary files, which the destructor removes. If no bake requests a frame, nothing
/// is simulated.
class SharedSimulation {
  public:
    /// `frames` are all frames that any of the bakes needs. `threads` is as for thread_count.
    SharedSimulation(const Preset& preset, std::vector<int> frames, int threads);

    /// Returns a source of frames for a bake. Its frames equal those of a simulation of `drawn` to
    /// the last bit. If the simulation fails, the source gives no frame and returns the outcome.
    /// The source reports the simulation as the phase States, throws the exceptions of
    /// simulate_into_cache and Cache, and keeps a reference to this object. Precondition: `drawn`
    /// has the same simulation_hash as the preset of this object.
    FrameSource source(const Preset& drawn);

  private:
    const RunOutcome& simulate(const ProgressCallback& on_progress);

    Preset preset_;
    std::vector<int> frames_;
    int threads_;
    std::optional<ScratchFolder> folder_;  // set when the simulation begins
    std::optional<RunOutcome> outcome_;    // nullopt until the foam has been simulated
    std::optional<Cache> cache_;           // set if the simulation is complete
};

/// Returns all frames that bakes of the presets need to draw the given frames: also the whole
/// animation if a preset has automatic ranges of maps, which are fitted to it.
std::vector<int> frames_to_simulate(const std::vector<Preset>& presets,
                                    const std::vector<int>& frames);

}  // namespace foam::texgen
