// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <foamtex/records.h>

namespace foam {

/// Returns the bubbles, films and junctions of a frame as plain values, for users of the library.
foamtex::FoamRecords records_of(const Frame& frame);

/// Returns the domain of a frame or a foam.
foamtex::Extent extent_of(const Domain& domain);

/// Returns the mean stress of a frame (core/foam/stress.h).
foamtex::Stress stress_record(const Frame& frame);

}  // namespace foam
