// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/library/with_public_errors.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/image/memory.h"
#include "texgen/preset/assignment.h"

namespace foam::texgen {

/// Returns work(). If work() throws PresetError, throws foamtex::ArgumentError instead; if work()
/// throws OutOfMemory, throws foamtex::Error instead. Other exceptions are converted as
/// with_public_errors converts them.
template <class Work>
auto with_texture_errors(const Work& work) {
    return with_public_errors([&] {
        try {
            return work();
        } catch (const PresetError& error) {
            throw foamtex::ArgumentError(error.what());
        } catch (const OutOfMemory& error) {
            throw foamtex::Error(error.what());
        }
    });
}

/// Throws foamtex::EquilibriumError if a run has not reached its last frame.
inline void throw_if_failed(const RunOutcome& outcome) {
    if (outcome.status != RunStatus::Complete) {
        throw foamtex::EquilibriumError(failure_of(outcome));
    }
}

}  // namespace foam::texgen
