#pragma once

#include "texgen/chart/chart.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

// Elements of an SVG document, each on a line of its own. Coordinates are in pixels, y points down.

/// The text with what XML takes for its own written as entities; control characters, which XML does
/// not allow, as spaces.
std::string escape_xml(std::string_view text);

/// "#rrggbb".
std::string svg_color(Srgb8 color);

/// Text that begins, has its middle or ends at the point, as `anchor` is start, middle or end;
/// `more` are further attributes.
std::string svg_text(ChartPoint at,
                     std::string_view anchor,
                     std::string_view text,
                     std::string_view more = "");

std::string svg_line(ChartPoint from, ChartPoint to);

/// Points joined by a line or drawn one by one, as the mark says.
std::string svg_series(std::span<const ChartPoint> points, Mark mark, Srgb8 color);

/// A filled rectangle between two corners, the upper left one first.
std::string svg_box(ChartPoint corner, ChartPoint opposite, Srgb8 color);

}  // namespace foam::texgen
