// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/normal.h"

#include "core/parallel/simd_level.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/relief.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace foam::texgen {

Keys<NormalOptions> normal_keys() {
    constexpr Choices<NormalY> kDirections = {{{{"gl", NormalY::Up}, {"dx", NormalY::Down}}}};
    return {key("y",
                kDirections,
                "direction of green: gl is up (Blender, Godot, Unity), dx is down (Unreal)",
                &NormalOptions::y)};
}

NumberPixels draw_normal(FrameLayers& layers,
                         const ReliefSource& source,
                         const NormalOptions& options) {
    const Relief relief(layers, source, Relief::kFoot);
    const PixelSlopes slopes = relief.slopes();
    Image<float> image(layers.grid().width, layers.grid().height, 3);
    at_simd_level([count = slopes.x.samples().size(),
                   slopes_x = slopes.x.samples().data(),
                   slopes_y = slopes.y.samples().data(),
                   normals = image.samples().data(),
                   up = options.y == NormalY::Up ? 1.0 : -1.0] {
        for (std::size_t k = 0; k < count; ++k) {
            const auto x = static_cast<double>(slopes_x[k]);
            const auto y = static_cast<double>(slopes_y[k]);
            const double length = std::sqrt(1.0 + x * x + y * y);
            normals[3 * k] = static_cast<float>(-x / length);
            normals[3 * k + 1] = static_cast<float>(-up * y / length);
            normals[3 * k + 2] = static_cast<float>(1.0 / length);
        }
    });
    return {std::move(image), -1.0, 1.0};
}

std::string note_on_normals(const NormalOptions& options) {
    return options.y == NormalY::Up ? "y up (OpenGL)" : "y down (DirectX)";
}

}  // namespace foam::texgen
