// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_file.h"
#include "core/io/format_error.h"
#include "tests/fuzz/fuzz_target.h"

#include <stdexcept>
#include <string>

namespace foam::fuzz {

void fuzz_evolver(std::string_view input) {
    const auto read = unless_rejected<FormatError>([&] { return read_evolver(input, "foam.fe"); });
    if (!read) {
        return;
    }
    const auto written =
        unless_rejected<std::range_error>([&] { return write_evolver(read->foam); });
    if (written) {
        const EvolverFoam again = read_evolver(*written, "written.fe");
        require(again.foam.network.bubble_count() == read->foam.network.bubble_count(),
                "a foam is read with the bubbles with which it was written");
    }
}

}  // namespace foam::fuzz
