// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/foam_shape.h"

#include "texgen/keys/value_kinds.h"

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::array<std::string_view, 2> kNamedOutlines{"disc", "rectangle"};

// Returns the outline that `text`, a value of FoamShape::outline, describes, before it is
// stretched.
foam::Outline unstretched_outline(const std::string& text) {
    if (text == "disc") {
        return disc_outline();
    }
    if (text == "rectangle") {
        return rectangle_outline(1.0);
    }
    return outline_from_wkt(text);
}

// Returns the reason why a text describes no outline; empty if it describes an outline.
std::string fault_of(const std::string& text) {
    try {
        outline_of({.outline = text});
        return {};
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

// The kind of values of foam.outline: "disc", "rectangle", or a polygon as WKT.
struct Outlines {
    std::string allowed() const {
        return "\"disc\", \"rectangle\", or a WKT polygon without self-intersections, such as "
               "\"POLYGON((0 0, 6 0, 6 4), (3 1, 5 1, 5 2))\"";
    }
    std::string schema() const {
        return R"({"type": "string", "pattern": "^(disc|rectangle| *[Pp][Oo][Ll][Yy][Gg][Oo][Nn].*)$"})";
    }
    std::span<const std::string_view> words() const { return kNamedOutlines; }
    bool read(const Value& value, std::string& member) const {
        std::string text;
        const bool allowed = Text{}.read(value, text) && fault_of(text).empty();
        member = allowed ? text : member;
        return allowed;
    }
    Value write(const std::string& member) const { return {member}; }
    std::string fault(const Value& value) const {
        const auto* text = std::get_if<std::string>(&value.data);
        return text != nullptr ? fault_of(*text) : std::string();
    }
};

void stretch(std::vector<Vec2>& corners, double factor) {
    for (Vec2& corner : corners) {
        corner.x() *= factor;
    }
}

}  // namespace

Keys<FoamShape> shape_keys() {
    constexpr Choices<FoamKind> kKinds = {
        {{{"torus", FoamKind::Torus}, {"patch", FoamKind::Patch}}}};
    return {key("domain",
                kKinds,
                "a torus, which tiles, or a patch with a free surface on a transparent background",
                &FoamShape::kind),
            key("outline",
                Outlines{},
                "initial outline of a patch, scaled to an area of one per bubble; in equilibrium "
                "the patch has another shape",
                &FoamShape::outline)
                .only_for("foam.domain", {"patch"}),
            key("outline_aspect",
                Reals{1.0 / 16.0, 16.0},
                "factor that stretches the outline in x; for a disc or a rectangle, width / height",
                &FoamShape::outline_aspect)
                .only_for("foam.domain", {"patch"})};
}

foam::Outline outline_of(const FoamShape& shape) {
    foam::Outline outline = unstretched_outline(shape.outline);
    stretch(outline.outer, shape.outline_aspect);
    for (std::vector<Vec2>& hole : outline.holes) {
        stretch(hole, shape.outline_aspect);
    }
    const double area = outline_area(outline);
    if (!(area > 0.0) || !std::isfinite(area)) {
        throw std::invalid_argument(
            "the outline has no area: it needs at least three corners that are not on one line");
    }
    return outline;
}

}  // namespace foam::texgen
