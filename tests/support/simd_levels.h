// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/simd_level.h"

#include <gtest/gtest.h>

#include <string>

namespace foam {

/// Calls body() once at each SIMD level of this machine.
template <class Body>
void at_every_simd_level(const Body& body) {
    for (const SimdLevel level : available_simd_levels()) {
        SCOPED_TRACE("SIMD level " + std::string(name_of(level)));
        const ForcedSimdLevel forced(level);
        body();
    }
}

}  // namespace foam
