// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_viewport.h"

#include "texgen/pictures/svg_text.h"

#include <array>

namespace foam::texgen {

namespace {

// Returns the fraction of the free space that lies before the content on one axis, that is, at the
// smaller coordinates. `align` is a word such as "xMidYMin". If it contains `at_begin`, such as
// "xMin", the content is at the beginning of the axis. If it contains `at_end`, such as "xMax", the
// content is at the end. Otherwise, the content is in the middle.
double alignment(std::string_view align, std::string_view at_begin, std::string_view at_end) {
    const auto has = [&](std::string_view word) { return align.find(word) != align.npos; };
    return has(at_begin) ? 0.0 : has(at_end) ? 1.0 : 0.5;
}

}  // namespace

std::optional<SvgViewBox> parse_svg_view_box(std::string_view attribute) {
    SvgText text(attribute);
    std::array<double, 4> numbers{};
    for (double& number : numbers) {
        const std::optional<double> found = text.number();
        if (!found) {
            return std::nullopt;
        }
        number = *found;
    }
    return SvgViewBox{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

AffineMap view_box_map(const SvgViewBox& box, std::string_view aspect_ratio, const Vec2& size) {
    SvgText text(aspect_ratio);
    const std::string_view align = text.word();
    Vec2 scale = size.cwiseQuotient(box.size);
    if (align != "none") {
        const bool covers = text.word() == "slice";
        scale = Vec2::Constant(covers ? scale.maxCoeff() : scale.minCoeff());
    }
    const Vec2 free_space = size - scale.cwiseProduct(box.size);
    const Vec2 fraction_before(alignment(align, "xMin", "xMax"), alignment(align, "YMin", "YMax"));
    const Vec2 shift = fraction_before.cwiseProduct(free_space) - scale.cwiseProduct(box.low);
    return {{scale.x(), 0.0, 0.0, scale.y(), shift.x(), shift.y()}};
}

}  // namespace foam::texgen
