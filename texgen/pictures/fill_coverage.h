// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/image/image.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// A filled shape: closed rings, which may cross themselves and each other.
struct FilledShape {
    std::vector<std::vector<Vec2>> rings;
    // The fill rule. If true, a point is inside if the rings wind around it an odd number of times.
    // If false, a point is inside if they wind around it any number of times except 0.
    bool is_even_odd = false;
};

/// Returns the fraction of each pixel that the union of the shapes covers. Pixel (x, y) is the
/// square from (x, y) to (x + 1, y + 1); row 0 is the lowest row. Each row of pixels is crossed by
/// eight horizontal lines. The length of each line that is covered within a pixel is exact; the
/// fraction is the mean over the eight lines. Precondition: the shapes are within
/// [0, width] x [0, height].
Image<float> fill_coverage(std::span<const FilledShape> shapes, int width, int height);

}  // namespace foam::texgen
