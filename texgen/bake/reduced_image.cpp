// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/reduced_image.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace foam::texgen {

RasterGrid ReducedImage::grid(std::optional<View> view) const {
    if (view) {
        view->pixels_per_unit /= reduction;
    }
    return {width, height, 0, 0, view};
}

void ReducedImage::apply_to(Preset& preset) const {
    preset.image.width = width;
    preset.image.height = height;
    preset.maps = options;
}

ReducedImage reduced_image(const Preset& preset, int side) {
    const int width = preset.image.width;
    const int height = preset.image.height;
    const int divisor = std::gcd(width, height);
    const std::int64_t wanted = static_cast<std::int64_t>(side) * divisor / std::max(width, height);
    const int parts = static_cast<int>(std::clamp<std::int64_t>(wanted, 1, divisor));
    ReducedImage reduced{.width = width / divisor * parts,
                         .height = height / divisor * parts,
                         .reduction = static_cast<double>(divisor) / parts,
                         .options = preset.maps};
    if (reduced.options.albedo.film_unit == WidthUnit::Pixels) {
        reduced.options.albedo.film_width /= reduced.reduction;
    }
    if (reduced.options.distance.unit == DistanceUnit::Pixels) {
        reduced.options.distance.full.value /= reduced.reduction;
    }
    return reduced;
}

}  // namespace foam::texgen
