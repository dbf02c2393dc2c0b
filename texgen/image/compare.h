// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/comparison.h"
#include "texgen/image/difference_limits.h"
#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstdint>

namespace foam::texgen {

/// The content of the pixels of a picture. The angle between two pixels is measured only if they
/// are Normals.
enum class PixelContent { Numbers, Normals };

/// Returns true if the pictures have the same width, height and channel names.
bool have_same_layout(const Picture& a, const Picture& b);

/// Compares two pictures. Pixels that cannot hold normals (can_hold_normals) are compared as
/// Numbers. If the layouts differ, the verdict is DifferentLayout and all other members keep their
/// defaults.
Comparison compare(const Picture& a,
                   const Picture& b,
                   const CompareLimits& limits = {},
                   PixelContent content = PixelContent::Numbers);

/// Returns a gray picture of the differences. A pixel shows the largest difference among its
/// channels. The largest difference in the whole picture is white. Precondition:
/// have_same_layout(a, b).
Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b);

}  // namespace foam::texgen
