// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/normal.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/relief.h"

#include <cmath>
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
    const double up = options.y == NormalY::Up ? 1.0 : -1.0;
    Image<float> image(layers.grid().width, layers.grid().height, 3);
    for (std::size_t k = 0; 3 * k < image.samples().size(); ++k) {
        const Vec2 slope = relief.slope(k);
        const double length = std::sqrt(1.0 + slope.squaredNorm());
        const auto normal = image.samples().subspan(3 * k, 3);
        normal[0] = static_cast<float>(-slope.x() / length);
        normal[1] = static_cast<float>(-up * slope.y() / length);
        normal[2] = static_cast<float>(1.0 / length);
    }
    return {std::move(image), -1.0, 1.0};
}

std::string note_on_normals(const NormalOptions& options) {
    return options.y == NormalY::Up ? "y up (OpenGL)" : "y down (DirectX)";
}

}  // namespace foam::texgen
