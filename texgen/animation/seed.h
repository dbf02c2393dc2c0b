// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Returns the first foam of a preset, which is not yet in equilibrium. It is a torus with the
/// aspect ratio of the image, or a patch. Throws std::invalid_argument if no patch can be seeded in
/// the outline.
Foam seeded_foam(const Preset& preset);

}  // namespace foam::texgen
