// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

namespace foam::texgen {

/// Points of a relief. The spans have one number per point; `Number` is float or const float.
template <class Number>
struct ReliefPoints {
    std::span<Number> slopes_x;  // the gradient of the height, x to the right
    std::span<Number> slopes_y;  // y up
    std::span<Number> sky;       // the visible fraction of the sky
};

}  // namespace foam::texgen
