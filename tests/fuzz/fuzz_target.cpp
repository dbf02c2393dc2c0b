// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace foam::fuzz {

const FuzzTarget& target_named(std::string_view name) {
    const std::span<const FuzzTarget> targets = all_targets();
    const auto found = std::ranges::find(targets, name, &FuzzTarget::name);
    if (found != targets.end()) {
        return *found;
    }
    std::fprintf(stderr, "there is no target '%s'; must be one of:", std::string(name).c_str());
    for (const FuzzTarget& target : targets) {
        std::fprintf(stderr, " %s", std::string(target.name).c_str());
    }
    std::fputc('\n', stderr);
    std::exit(2);
}

void require(bool holds, std::string_view requirement) {
    if (!holds) {
        std::fprintf(stderr, "requirement violated: %s\n", std::string(requirement).c_str());
        std::abort();
    }
}

}  // namespace foam::fuzz
