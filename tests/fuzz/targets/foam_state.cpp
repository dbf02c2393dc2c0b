// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_json.h"
#include "core/io/format_error.h"
#include "tests/fuzz/fuzz_target.h"

#include <string>

namespace foam::fuzz {

void fuzz_foam_state(std::string_view input) {
    const auto foam =
        unless_rejected<FormatError>([&] { return read_foam_json(input, "foam.json"); });
    if (!foam) {
        return;
    }
    const std::string written = write_foam_json(*foam);
    require(write_foam_json(read_foam_json(written, "written.json")) == written,
            "a state is read as it was written");
}

}  // namespace foam::fuzz
