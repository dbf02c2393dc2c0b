// SPDX-License-Identifier: Apache-2.0

#include "core/foam/outline.h"
#include "tests/fuzz/fuzz_target.h"

#include <span>
#include <stdexcept>
#include <string>

namespace foam::fuzz {

void fuzz_wkt_polygon(std::string_view input) {
    const auto outline = unless_rejected<std::invalid_argument>(
        [&] { return outline_from_wkt(std::string(input)); });
    if (!outline) {
        return;
    }
    require(outline->outer.size() >= 3, "a polygon has three corners");
    require(outline_area(*outline) >= 0.0, "the area of a polygon is not negative");
    is_inside(*outline, outline->outer.front());
    require(bounding_aspect(std::span(&*outline, 1)) > 0.0, "a polygon has a width");
    outline_centroid(*outline);
}

}  // namespace foam::fuzz
