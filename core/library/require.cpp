// SPDX-License-Identifier: Apache-2.0

#include "core/library/require.h"

#include "core/parallel/parallel_for.h"

#include <fmt/core.h>
#include <foamtex/errors.h>

namespace foam {

void require(bool holds, std::string_view name, std::string_view allowed, std::string_view given) {
    if (!holds) {
        throw foamtex::ArgumentError(
            fmt::format("{}: must be {}, but is {}", name, allowed, given));
    }
}

void require(bool holds, std::string_view name, std::string_view allowed, double given) {
    if (!holds) {
        require(false, name, allowed, fmt::format("{}", given));
    }
}

void require_from(std::string_view name, double given, double low, double high) {
    const bool holds = given >= low && given <= high;
    require(holds, name, fmt::format("from {} to {}", low, high), given);
}

void require_threads(int threads) {
    require_from("threads", threads, 0, kMaxThreads);
}

}  // namespace foam
