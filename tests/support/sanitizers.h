// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::test {

/// False if the program surely has no sanitizers, which need memory and address space of their own.
/// True for every program that Clang compiles, because Clang does not define GCC's macros for
/// sanitizers.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__clang__)
inline constexpr bool kMayHaveSanitizers = true;
#else
inline constexpr bool kMayHaveSanitizers = false;
#endif

}  // namespace foam::test
