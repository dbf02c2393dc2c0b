// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/foam_record.h"
#include "texgen/maps/per_bubble.h"

namespace foam::texgen {

/// The values of all bubbles of a frame, and the mean area of the bubbles.
struct FoamValues {
    PerBubble<BubbleValues> bubbles;
    double mean_area = 1.0;  // square foam units; 1 if there are no bubbles
};

/// Returns the values of the bubbles in this frame alone, not averaged over recent frames.
FoamValues present_values(const Frame& frame);

/// Returns the values by which maps choose the color or tone of a bubble: the averages over recent
/// frames if the record has averages, otherwise the present values. The maps area, sides and growth
/// use present values instead. Precondition: `record` is the record of the frame.
FoamValues shown_values(const Frame& frame, const FoamRecord& record);

/// Returns the present values in the form in which RecentAverages averages them: a pressure p, in
/// units of PressureUnit::Current, is replaced by p / (1 + |p|).
FoamValues values_to_average(const Frame& frame);

}  // namespace foam::texgen
