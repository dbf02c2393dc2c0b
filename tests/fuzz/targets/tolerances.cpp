// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/tolerances.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/assignment.h"

namespace foam::fuzz {

void fuzz_tolerances(std::string_view input) {
    const auto tolerances = unless_rejected<texgen::PresetError>(
        [&] { return texgen::parse_tolerances(input, "limits.toml"); });
    if (tolerances) {
        tolerances->limits_of("normal");
    }
}

}  // namespace foam::fuzz
