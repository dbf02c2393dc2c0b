// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the rectangle over which foam.density, the field of bubble sizes, is stretched. This is
/// the torus, which has the aspect ratio of the image, or the bounding box of the outline of a
/// patch.
DensityDomain density_domain(const Preset& preset);

/// Returns remarks on a preset that users should see, one line each. They are about keys that the
/// assignments set without effect (unused_keys), and about the picture of foam.density
/// (density_remarks). Precondition: the assignments have been stored in the preset.
std::vector<std::string> remarks_on(const Preset& preset, std::span<const Assignment> assignments);

/// Returns a line for each key of maps that the assignments set although none of the drawn maps
/// (source_maps) uses it. An example of a line is "lit.elevation has no effect on the drawn map
/// height".
std::vector<std::string> keys_without_maps(const Preset& preset,
                                           std::span<const Assignment> assignments);

}  // namespace foam::texgen
