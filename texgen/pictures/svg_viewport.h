// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/pictures/bezier_path.h"

#include <optional>
#include <string_view>

namespace foam::texgen {

/// The rectangle of an attribute `viewBox`, in the coordinates of the content of an element.
struct SvgViewBox {
    Vec2 low;
    Vec2 size;
};

/// Returns the rectangle of an attribute `viewBox`, or nullopt if the text does not begin with four
/// numbers. Browsers ignore such an attribute, too.
std::optional<SvgViewBox> parse_svg_view_box(std::string_view attribute);

/// Returns the map from the coordinates of the content of an element to the coordinates of its
/// viewport. The viewport is a rectangle of the given size with a corner at the origin.
/// `aspect_ratio` is the attribute `preserveAspectRatio`; a missing or unknown word stands for the
/// default, "xMidYMid meet". Precondition: the rectangle of `box` is not empty.
AffineMap view_box_map(const SvgViewBox& box, std::string_view aspect_ratio, const Vec2& size);

}  // namespace foam::texgen
