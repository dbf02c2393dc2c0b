// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset.h"

#include <vector>

namespace foam::texgen {

/// The wanted length of the longer side of the reduced images to which ranges are fitted, in
/// pixels.
inline constexpr int kMeasuredSide = 512;

/// Returns the maps of the preset that have an automatic range (AutoReal) and need it. A map needs
/// its range if the files store codes (integers, as in a PNG), or if the map is packed.
std::vector<const Map*> maps_with_automatic_ranges(const Preset& preset);

/// Returns true if maps_with_automatic_ranges returns at least one map.
bool has_automatic_ranges(const Preset& preset);

/// Fits the automatic ranges of the maps of a preset to the numbers in the given frames. These are
/// usually all frames of the animation, so that the ranges do not depend on the frames that are
/// baked.
///
/// The maps are drawn at a reduced size with exactly the aspect ratio of the preset. The longer
/// side then has at most 512 pixels, if the width and the height have a large enough common
/// divisor. The range of a map results from the largest absolute value of its numbers, in the unit
/// of the key of its range (such as height.full). This value is increased by 1 % and rounded up to
/// a preferred number times a power of 10. The preferred numbers are the series R10 of ISO 3: 1,
/// 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8, 10. The result becomes the value of the key. A range thus
/// exceeds the largest absolute value by at most 30 %. A map whose numbers are all 0, or only
/// rounding errors (fitted_range), keeps its range.
///
/// `source` gives the frames. The maps are drawn on thread_count(threads) threads. `on_progress`
/// receives the phases of the source, and then the phase Ranges. If the source fails, its outcome
/// is returned, and the preset is unchanged. Throws the exceptions of the source and of the
/// callback.
RunOutcome fit_automatic_ranges(Preset& preset,
                                const FrameSource& source,
                                const std::vector<int>& frames,
                                int threads,
                                const ProgressCallback& on_progress = {});

/// Returns the range of a map that fits its numbers. `range` is the present range, and `largest` is
/// the largest absolute value of the numbers, divided by the present range. If `largest` is so
/// small that the numbers are rounding errors, returns the present range.
double fitted_range(double range, double largest);

/// Returns the smallest product of a preferred number (see above) and a power of 10 that is not
/// below `number`. Precondition: `number` is positive.
double rounded_up(double number);

}  // namespace foam::texgen
