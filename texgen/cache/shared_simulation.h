// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/scratch_folder.h"
#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/cache/cache.h"
#include "texgen/preset/preset.h"

#include <map>
#include <optional>
#include <vector>

namespace foam::texgen {

/// One simulation for several passes over the frames of a preset, such as fitting automatic ranges
/// and drawing, or drawing in several sizes. The first pass receives each frame as soon as it is
/// simulated. The states are stored in a cache in the system's folder for temporary files, from
/// which further passes read them. If the states cannot be stored, because this folder cannot be
/// written or its disk is full, each pass runs a simulation of its own. The destructor removes the
/// cache. Without any pass, nothing is simulated.
class SharedSimulation {
  public:
    /// `frames` are all frames that any of the passes needs. `threads` has the same meaning as in
    /// the function thread_count.
    SharedSimulation(const Preset& preset, std::vector<int> frames, int threads);

    /// Returns a source of frames for one or more passes. Its frames equal those of a simulation of
    /// `drawn` to the last bit. If the simulation fails, the first pass receives the frames before
    /// the failure, and further passes receive no frame. All passes return the outcome of the
    /// simulation. The source throws the exceptions of Simulation and Cache, and keeps a reference
    /// to this object. Precondition: `drawn` has the same simulation_hash as the preset of this
    /// object.
    FrameSource source(const Preset& drawn);

  private:
    RunOutcome simulate(FrameAssembly& assembly, const ProgressCallback& on_progress);
    FrameSource stored_frames(const Preset& drawn) const;

    Preset preset_;
    std::vector<int> frames_;
    int threads_;
    std::optional<ScratchFolder> folder_;  // nullopt if a state could not be stored
    std::optional<RunOutcome> outcome_;    // nullopt until the foam has been simulated
    std::optional<Cache> cache_;           // set if the simulation is complete and stored
    // For each state, by its number: the FrameEffort of the steps from the state before it.
    std::map<int, FrameEffort> efforts_;
};

/// Returns the frames that are in one of the lists or in both, each once, in increasing order.
std::vector<int> united(const std::vector<int>& some, const std::vector<int>& others);

/// Returns the frames that must be simulated to bake the given frames of the presets. These are the
/// given frames and, if a preset has automatic ranges of maps, all frames of its animation.
/// Automatic ranges are fitted to all frames of an animation.
std::vector<int> frames_to_simulate(const std::vector<Preset>& presets,
                                    const std::vector<int>& frames);

}  // namespace foam::texgen
