// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/simd_level.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace foam {

// The level is decided at the first call of simd_level(), unless it has been forced before, and is
// stored in an atomic variable. If several threads make this first call at once, all of them decide
// on the same level.

namespace {

bool is_available(SimdLevel level) {
#ifdef FOAM_HAS_SIMD_LEVELS
    switch (level) {
        case SimdLevel::Avx512:
            return __builtin_cpu_supports("avx512f") != 0 &&
                   __builtin_cpu_supports("avx512bw") != 0 &&
                   __builtin_cpu_supports("avx512cd") != 0 &&
                   __builtin_cpu_supports("avx512dq") != 0 &&
                   __builtin_cpu_supports("avx512vl") != 0;
        case SimdLevel::Avx2:
            return __builtin_cpu_supports("avx2") != 0;
        case SimdLevel::Baseline:
            return true;
    }
#endif
    return level == SimdLevel::Baseline;
}

std::string available_names() {
    std::string names;
    for (const SimdLevel level : available_simd_levels()) {
        names += (names.empty() ? "" : ", ") + std::string(name_of(level));
    }
    return names;
}

SimdLevel level_named(std::string_view name) {
    const std::vector<SimdLevel> levels = available_simd_levels();
    const auto found = std::find_if(
        levels.begin(), levels.end(), [&](SimdLevel level) { return name_of(level) == name; });
    if (found == levels.end()) {
        throw std::invalid_argument("environment variable FOAMTEX_SIMD = '" + std::string(name) +
                                    "': this machine supports only " + available_names());
    }
    return *found;
}

}  // namespace

std::vector<SimdLevel> available_simd_levels() {
    std::vector<SimdLevel> levels;
    for (const SimdLevel level : {SimdLevel::Baseline, SimdLevel::Avx2, SimdLevel::Avx512}) {
        if (is_available(level)) {
            levels.push_back(level);
        }
    }
    return levels;
}

std::string_view name_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::Avx512:
            return "avx512";
        case SimdLevel::Avx2:
            return "avx2";
        case SimdLevel::Baseline:
            break;
    }
    return "baseline";
}

void force_simd_level(SimdLevel level) {
    if (!is_available(level)) {
        throw std::invalid_argument(
            "SIMD level '" + std::string(name_of(level)) +
            "' is not available on this machine; available: " + available_names());
    }
    detail::simd_level.store(static_cast<int>(level), std::memory_order_relaxed);
}

SimdLevel detail::decide_simd_level() {
    const char* const name = std::getenv("FOAMTEX_SIMD");
    const bool is_set = name != nullptr && *name != '\0';
    const SimdLevel level = is_set ? level_named(name) : available_simd_levels().back();
    simd_level.store(static_cast<int>(level), std::memory_order_relaxed);
    return level;
}

}  // namespace foam
