// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/preset/preset.h"

#include <vector>

namespace foam::texgen {

/// Returns true if a map of the preset has an automatic range (AutoReal), and the files store
/// codes, which need a range.
bool has_automatic_ranges(const Preset& preset);

/// Fits the automatic ranges of all maps of a preset to the numbers that occur in the given frames,
/// usually all frames of the animation, so that the ranges do not depend on the frames that are
/// baked. The maps are drawn at a reduced size of exactly the same aspect ratio: the longer side
/// has at most 512 pixels if the width and the height have a large enough common divisor. The
/// largest number, plus 1 %, is rounded up to a preferred number of the series R10 of ISO 3 (1,
/// 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8, 10). A range thus exceeds the largest number by at most
/// 30 %. A map whose numbers are all 0 keeps its range.
///
/// `source` gives the frames. `on_progress` receives the phases of the source, and then the phase
/// Ranges. If the source fails, its outcome is returned, and the preset is unchanged.
RunOutcome fit_automatic_ranges(Preset& preset,
                                const FrameSource& source,
                                const std::vector<int>& frames,
                                int threads,
                                const ProgressCallback& on_progress = {});

/// Returns the smallest preferred number, times a power of 10, that is not below a positive number.
double rounded_up(double number);

}  // namespace foam::texgen
