// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <numbers>

namespace foam::texgen {

/// One degree in radians.
inline constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace foam::texgen
