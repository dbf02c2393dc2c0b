// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

namespace foam::texgen {

/// The size of a cache line in bytes.
inline constexpr std::size_t kLineBytes = 64;

}  // namespace foam::texgen
