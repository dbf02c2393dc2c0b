// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <foamtex/records.h>

#include <vector>

namespace foam {

/// Returns the bubbles of a frame as plain values: first those of the network, then lone bubbles.
std::vector<foamtex::Bubble> bubble_records(const Frame& frame);

/// Returns the bubbles, films and junctions of a frame as plain values, for users of the library.
foamtex::FoamRecords records_of(const Frame& frame);

/// Returns a domain as plain values.
foamtex::Extent extent_of(const Domain& domain);

/// Returns a stress (core/foam/stress.h) as plain values.
foamtex::Stress stress_record(const Mat2& stress);

/// Returns events as plain values.
std::vector<foamtex::Event> event_records(const std::vector<TopologyEvent>& events);

}  // namespace foam
