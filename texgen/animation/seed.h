// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Returns the first foam of a preset: a torus with the aspect ratio of the image, or a patch in
/// the outline of the preset. This foam is a raw diagram (core/foam/seeding.h), not in equilibrium.
/// Throws std::invalid_argument if no valid foam can be seeded (seed_foam, seed_patch).
Foam seeded_foam(const Preset& preset);

}  // namespace foam::texgen
