// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/oklab.h"

#include "core/geometry/elementary.h"

#include <algorithm>

namespace foam::texgen {

namespace {

double cube(double x) {
    return x * x * x;
}

double cube_root(double x) {
    return ieee::pow(std::max(0.0, x), 1.0 / 3.0);
}

}  // namespace

Oklab to_oklab(const LinearRgb& color) {
    const double l =
        cube_root(0.4122214708 * color.r + 0.5363325363 * color.g + 0.0514459929 * color.b);
    const double m =
        cube_root(0.2119034982 * color.r + 0.6806995451 * color.g + 0.1073969566 * color.b);
    const double s =
        cube_root(0.0883024619 * color.r + 0.2817188376 * color.g + 0.6299787005 * color.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

LinearRgb to_linear(const Oklab& color) {
    const double l = cube(color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b);
    const double m = cube(color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b);
    const double s = cube(color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

}  // namespace foam::texgen
