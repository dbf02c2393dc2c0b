// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Adds a whole multiple of the width to Domain::shear, so that the magnitude of the shear is at
/// most half of the width. The changed periods describe the same lattice: no junction moves, only
/// lattice offsets change.
void reduce_lattice(Foam& foam);

}  // namespace foam
