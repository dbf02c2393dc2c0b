#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// The foam that a preset begins with, not yet in equilibrium: a torus with the aspect of the
/// image, or a patch. Throws std::invalid_argument where no patch can be seeded in the outline.
Foam seeded_foam(const Preset& preset);

}  // namespace foam::texgen
