// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace foam {

/// The instruction sets for which vectorized loops are compiled. All levels perform the same IEEE
/// operations, without fused multiply-add, so that results have the same bits on every level.
enum class SimdLevel {
    Baseline,  // the baseline of the architecture: SSE2 on x86-64
    Avx2,
    Avx512,  // the AVX-512 subsets F, BW, CD, DQ and VL
};

/// Returns the levels that this machine can run, lowest first.
std::vector<SimdLevel> available_simd_levels();

/// Returns "baseline", "avx2" or "avx512".
std::string_view name_of(SimdLevel level);

namespace detail {
inline constexpr int kUndecided = -1;
// The level in use as a number, or kUndecided.
inline std::atomic<int> simd_level{kUndecided};
// Decides the level from FOAMTEX_SIMD and the available levels, stores it and returns it.
SimdLevel decide_simd_level();
}  // namespace detail

/// Returns the level in use. This is the highest available level, unless the environment variable
/// FOAMTEX_SIMD names another level or force_simd_level was called. If no level has been decided or
/// forced before, this function reads FOAMTEX_SIMD. It then throws std::invalid_argument if the
/// variable is not empty and names no available level.
inline SimdLevel simd_level() {
    const int level = detail::simd_level.load(std::memory_order_relaxed);
    return level != detail::kUndecided ? static_cast<SimdLevel>(level)
                                       : detail::decide_simd_level();
}

/// Sets the level in use, which simd_level() returns from now on. Tests call this function. Throws
/// std::invalid_argument if the level is not available.
void force_simd_level(SimdLevel level);

/// Forces a level for the duration of a scope, then restores the previous level.
class ForcedSimdLevel {
  public:
    explicit ForcedSimdLevel(SimdLevel level) : previous_(simd_level()) { force_simd_level(level); }
    ~ForcedSimdLevel() {
        detail::simd_level.store(static_cast<int>(previous_), std::memory_order_relaxed);
    }
    ForcedSimdLevel(const ForcedSimdLevel&) = delete;
    ForcedSimdLevel& operator=(const ForcedSimdLevel&) = delete;

  private:
    SimdLevel previous_;
};

#if defined(__GNUC__) && defined(__x86_64__)
#define FOAM_HAS_SIMD_LEVELS
#endif

namespace detail {

// Calls kernel(Level) if the kernel accepts a level as an argument (see at_simd_level), otherwise
// kernel(). Returns the result.
template <SimdLevel Level, class Kernel>
[[gnu::always_inline]] inline auto call_kernel(Kernel& kernel) {
    if constexpr (std::is_invocable_v<Kernel&, std::integral_constant<SimdLevel, Level>>) {
        return kernel(std::integral_constant<SimdLevel, Level>{});
    } else {
        return kernel();
    }
}

// These functions run a kernel at one level. The attribute `flatten` inlines the kernel and the
// functions that the kernel calls, so that this code is compiled for the level. Large functions are
// an exception: they must also have the attribute `always_inline`. The targets name exactly the
// instruction sets for which available_simd_levels() tests. A processor name would not do:
// x86-64-v4, for example, also contains BMI2, which a virtual machine may lack.
template <class Kernel>
[[gnu::flatten, gnu::noinline]] auto run_at_baseline(Kernel kernel) {
    return call_kernel<SimdLevel::Baseline>(kernel);
}
#ifdef FOAM_HAS_SIMD_LEVELS
template <class Kernel>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] auto run_at_avx2(Kernel kernel) {
    return call_kernel<SimdLevel::Avx2>(kernel);
}
template <class Kernel>
[[gnu::target("avx512f,avx512bw,avx512cd,avx512dq,avx512vl"), gnu::flatten, gnu::noinline]] auto
run_at_avx512(Kernel kernel) {
    return call_kernel<SimdLevel::Avx512>(kernel);
}
#endif

}  // namespace detail

/// Runs a kernel at simd_level() and returns its result. The kernel is a lambda whose loops the
/// compiler vectorizes. It is compiled once for each level (only for the baseline if
/// FOAM_HAS_SIMD_LEVELS is not defined). If it accepts an argument of type
/// std::integral_constant<SimdLevel, level>, it is called as kernel(level), otherwise as kernel().
/// It should capture by value: a variable that is captured by reference has an address, so the
/// compiler must assume that every store might change the variable.
///
/// Precondition: all functions that the kernel calls are defined in the same translation unit, so
/// that they can be inlined.
template <class Kernel>
auto at_simd_level(Kernel kernel) {
#ifdef FOAM_HAS_SIMD_LEVELS
    switch (simd_level()) {
        case SimdLevel::Avx512:
            return detail::run_at_avx512(std::move(kernel));
        case SimdLevel::Avx2:
            return detail::run_at_avx2(std::move(kernel));
        case SimdLevel::Baseline:
            break;
    }
#endif
    return detail::run_at_baseline(std::move(kernel));
}

}  // namespace foam
