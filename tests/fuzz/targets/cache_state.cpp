// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/fuzz_target.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/state_codec.h"

#include <vector>

namespace foam::fuzz {

void fuzz_cache_state(std::string_view input) {
    const std::vector<double> first_pressures = {0.0, 1.0};
    // In a cache without pressures.foam, states must contain their pressures.
    unless_rejected<texgen::BadContent>([&] { return texgen::unpack_state(bytes_of(input), {}); });
    auto state = unless_rejected<texgen::BadContent>(
        [&] { return texgen::unpack_state(bytes_of(input), first_pressures); });
    if (!state) {
        return;
    }
    const Bytes packed = texgen::pack_state(*state, first_pressures);
    state.reset();  // two states of bubbles with large identities would exceed the limit of memory
    const texgen::SimulatedFrame again = texgen::unpack_state(packed, first_pressures);
    require(texgen::pack_state(again, first_pressures) == packed,
            "a state is read as it was written");
}

}  // namespace foam::fuzz
