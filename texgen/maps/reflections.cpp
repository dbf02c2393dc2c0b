// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/reflections.h"

#include "core/geometry/elementary.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/degree.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr double kSharpest = 0.01;     // smallest softness; an edge of this softness looks sharp
constexpr double kSecondWindow = 0.4;  // brightness of a window relative to the one before it

}  // namespace

Keys<ReflectionOptions> reflection_keys() {
    using Options = ReflectionOptions;
    return {key("windows",
                Integers{0, 2},
                "number of windows that every bubble reflects: the first in the direction of the "
                "light, the second, fainter one at the opposite azimuth",
                &Options::windows)
                .in("windows"),
            key("window_size",
                Reals{1.0, 120.0},
                "width and height of a window, degrees",
                &Options::window_size)
                .in("degrees")
                .unused_with("lit.windows", {"0"}),
            key("window_softness",
                kFractions,
                "width of the soft border of a window, as a fraction of its size",
                &Options::window_softness)
                .in("fraction of the size")
                .unused_with("lit.windows", {"0"}),
            key("window_brightness",
                Reals{0.0, 1000.0},
                "brightness of the reflection of the first window",
                &Options::window_brightness)
                .unused_with("lit.windows", {"0"}),
            key("horizon",
                Reals{0.0, 1000.0},
                "factor on the brightness of the reflected sky, which is brightest near the "
                "horizon and appears as a ring in every dome that is steep enough",
                &Options::horizon)};
}

Direction direction_of(double azimuth, double elevation) {
    return {ieee::cos(elevation * kDegree) * ieee::cos(azimuth * kDegree),
            ieee::cos(elevation * kDegree) * ieee::sin(azimuth * kDegree),
            ieee::sin(elevation * kDegree)};
}

Window::Window(double azimuth, double elevation, double degrees, double softness)
    : middle_(direction_of(azimuth, elevation)),
      across_(direction_of(azimuth + 90.0, 0.0)),
      upward_(middle_.cross(across_)),
      half_size_(ieee::tan(0.5 * degrees * kDegree)),
      softness_(std::max(softness, kSharpest)) {}

Reflections::Reflections(const ReflectionOptions& options, double azimuth, double elevation)
    : has_windows_(options.windows > 0), horizon_(options.horizon) {
    double brightness = options.window_brightness;
    for (int k = 0; k < options.windows; ++k) {
        const auto index = static_cast<std::size_t>(k);
        windows_[index] =
            Window(azimuth + 180.0 * k, elevation, options.window_size, options.window_softness);
        brightnesses_[index] = brightness;
        brightness *= kSecondWindow;
    }
    flat_ = light_from(Direction::UnitZ());
}

}  // namespace foam::texgen
