#pragma once

#include <cstddef>

namespace foam::texgen {

/// What a processor's caches read and write at once, in bytes.
inline constexpr std::size_t kLineBytes = 64;

}  // namespace foam::texgen
