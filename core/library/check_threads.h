// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <foamtex/errors.h>

namespace foam {

/// Throws foamtex::ArgumentError unless `threads` is from 0 to 256.
inline void check_threads(int threads) {
    constexpr int kMaxThreads = 256;
    if (threads < 0 || threads > kMaxThreads) {
        throw foamtex::ArgumentError("threads: must be from 0 to 256");
    }
}

}  // namespace foam
