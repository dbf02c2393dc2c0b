// SPDX-License-Identifier: Apache-2.0

// The functions that libFuzzer calls. The environment variable FOAMTEX_FUZZ_TARGET names the
// target; libFuzzer passes the environment, but not its own arguments, to the processes it starts.

#include "tests/fuzz/fuzz_target.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

constexpr double kLongestRun = 1.0;  // seconds of processor time

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

const foam::fuzz::FuzzTarget& chosen_target() {
    const char* const name = std::getenv("FOAMTEX_FUZZ_TARGET");
    return foam::fuzz::target_named(name == nullptr ? "" : name);
}

}  // namespace

// Limits the processor time of a run. Unlike the time limit of libFuzzer, this limit does not
// depend on other programs that the machine runs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const foam::fuzz::FuzzTarget& target = chosen_target();
    const double start = processor_seconds();
    target.run({reinterpret_cast<const char*>(data), size});
    foam::fuzz::require(processor_seconds() - start < kLongestRun,
                        "a run takes less than a second of processor time");
    return 0;
}
