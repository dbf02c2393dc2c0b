// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/comparison.h"
#include "texgen/image/difference_limits.h"
#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstdint>

namespace foam::texgen {

/// The meaning of the pixels of two compared pictures.
enum class PixelContent {
    Numbers,  // independent samples
    Normals,  // vectors of three samples; the angles between them are measured, too
};

/// Returns true if the pictures have the same width, height and channel names.
bool have_same_layout(const Picture& a, const Picture& b);

/// Compares two pictures. If `content` is Normals, but the pixels cannot be normals
/// (can_hold_normals), they are compared as Numbers. If the layouts differ, the verdict is
/// DifferentLayout and all other members keep their defaults.
Comparison compare(const Picture& a,
                   const Picture& b,
                   const CompareLimits& limits = {},
                   PixelContent content = PixelContent::Numbers);

/// Returns a picture of one channel that shows the differences. A pixel shows the largest
/// difference among its channels, from 0 for no difference to 65535 for the largest difference in
/// the whole picture. Precondition: have_same_layout(a, b).
Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b);

}  // namespace foam::texgen
