#include "texgen/preset/foam_shape.h"

#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

foam::Outline unstretched_outline(const std::string& text) {
    if (text == "disc") {
        return disc_outline();
    }
    if (text == "rectangle") {
        return rectangle_outline(1.0);
    }
    return outline_from_wkt(text);
}

void stretch(std::vector<Vec2>& corners, double factor) {
    for (Vec2& corner : corners) {
        corner.x() *= factor;
    }
}

}  // namespace

foam::Outline outline_of(const FoamShape& shape) {
    foam::Outline outline = unstretched_outline(shape.outline);
    stretch(outline.outer, shape.outline_aspect);
    for (std::vector<Vec2>& hole : outline.holes) {
        stretch(hole, shape.outline_aspect);
    }
    const double area = outline_area(outline);
    if (!(area > 0.0) || !std::isfinite(area)) {
        throw std::invalid_argument("the outline has no area");
    }
    return outline;
}

}  // namespace foam::texgen
