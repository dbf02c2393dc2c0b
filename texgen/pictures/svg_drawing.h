// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/pictures/bezier_path.h"

#include <string_view>
#include <vector>

namespace foam::texgen {

/// A filled shape of an SVG, in the coordinates of the document: y points down.
struct SvgShape {
    BezierPath path;
    bool is_even_odd = false;  // the fill rule
};

/// Returns the filled shapes of an SVG: paths, rectangles, circles, ellipses, polygons and
/// polylines, also within groups, links and symbols that the drawing uses. All colors count as
/// filled, except "none" and "transparent". Hidden elements are left out: those with the display
/// "none", the opacity 0 or a visibility other than "visible". Strokes, pictures, clipping paths
/// and style sheets are ignored. Viewports of nested <svg> and <symbol> move and scale shapes, but
/// do not clip them.
///
/// Throws InputError, whose message does not name the file, in these cases:
/// - The document is no SVG, or it contains visible text.
/// - An attribute that a filled shape needs is malformed.
/// - A <use> refers to no element.
/// - The document has more than 100,000 lines, curves and subpaths, more than 200,000 elements,
///   or more than 64 levels of nesting. An element counts each time that a <use> draws it.
std::vector<SvgShape> read_svg_shapes(std::string_view document);

}  // namespace foam::texgen
