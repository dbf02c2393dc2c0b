// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/pictures/bezier_path.h"

#include <string_view>

namespace foam::texgen {

/// Returns the path of the attribute `d` of an SVG path. Open subpaths count as closed, as they do
/// when a path is filled. Throws InputError if the text is not the data of a path; the message
/// gives the position, but not the file.
BezierPath parse_svg_path(std::string_view data);

/// Returns the affine map that an attribute `transform` describes. Throws InputError if the text is
/// not a list of transforms; the message does not name the file.
AffineMap parse_svg_transform(std::string_view attribute);

/// Returns a polygon from an attribute `points`. Throws InputError if the text is not a list of
/// points; the message does not name the file.
BezierPath parse_svg_points(std::string_view attribute);

}  // namespace foam::texgen
