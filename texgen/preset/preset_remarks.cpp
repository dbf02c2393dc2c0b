// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_remarks.h"

#include "texgen/preset/conditions.h"

#include <algorithm>
#include <iterator>

namespace foam::texgen {

DensityDomain density_domain(const Preset& preset) {
    if (preset.shape.kind == FoamKind::Torus) {
        return {true, static_cast<double>(preset.image.width) / preset.image.height};
    }
    return {false, bounding_aspect(outline_of(preset.shape))};
}

std::vector<std::string> remarks_on(const Preset& preset, std::span<const Assignment> assignments) {
    std::vector<std::string> remarks = unused_keys(preset, assignments);
    if (preset.density.source.picture.is_set()) {
        std::ranges::copy(density_remarks(preset.density, density_domain(preset)),
                          std::back_inserter(remarks));
    }
    return remarks;
}

}  // namespace foam::texgen
