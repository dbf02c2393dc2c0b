#pragma once

#include "texgen/stats/record.h"

#include <span>

namespace foam::texgen {

/// The frames of a run with bubbles enough for means over the foam to tell something, 100, from the
/// first on; all frames where the first has fewer.
std::span<const FrameRecord> measurable(const RunRecord& run);

/// The measurable frames in which the foam has lost memory of its seed and only its scale still
/// changes: those in which no more than a quarter of the first bubbles are left.
std::span<const FrameRecord> scaling_state(const RunRecord& run);

}  // namespace foam::texgen
