// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <array>
#include <string_view>

namespace foam::texgen {

/// A chromaticity: the coordinates x and y of the CIE 1931 color space.
struct Chromaticity {
    double x;
    double y;
};

/// The colors that the numbers (1, 0, 0), (0, 1, 0), (0, 0, 1) and (1, 1, 1) represent.
struct Chromaticities {
    Chromaticity red;
    Chromaticity green;
    Chromaticity blue;
    Chromaticity white;
};

/// Returns the chromaticities of a color space. Primaries::Srgb has those of ITU-R BT.709 with the
/// white point D65 (IEC 61966-2-1). Primaries::AcesCg has the primaries AP1 with the white point of
/// ACES, about D60 (the Academy's specification S-2014-004, "ACEScg - A Working Space for CGI
/// Render and Compositing").
Chromaticities chromaticities_of(Primaries primaries);

/// The rows of a matrix that is multiplied by a color, a column vector of red, green and blue.
using ColorMatrix = std::array<std::array<double, 3>, 3>;

/// Returns the matrix that converts linear light from one color space to another. If the white
/// points differ, white is adapted with the Bradford transform (K. M. Lam, "Metamerism and colour
/// constancy", 1985), so that (1, 1, 1) stays (1, 1, 1).
ColorMatrix conversion(Primaries from, Primaries to);

/// Returns the name of the color space of linear light with these primaries, as manifests state it:
/// "linear sRGB" or "ACEScg".
std::string_view linear_space_name(Primaries primaries);

/// Converts the colors of a layer of a picture: the channels LAYER.R, LAYER.G and LAYER.B or, if
/// `layer` is empty, R, G and B. The colors are linear light, which may be multiplied by an
/// opacity. Other channels stay the same. Does nothing if `from` equals `to`, or if one of the
/// three channels is missing or does not store floats.
void convert_colors(Picture& picture, std::string_view layer, Primaries from, Primaries to);

}  // namespace foam::texgen
