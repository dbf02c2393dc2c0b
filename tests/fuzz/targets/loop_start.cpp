// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_start.h"

#include "core/files/file_io.h"
#include "core/io/format_error.h"
#include "tests/fuzz/fuzz_target.h"

namespace foam::fuzz {

void fuzz_loop_start(std::string_view input) {
    const auto start = unless_rejected<InputError, FormatError>(
        [&] { return texgen::read_loop_start(input, "loop.json"); });
    if (!start) {
        return;
    }
    const std::string written = texgen::write_loop_start(*start, "hash");
    require(texgen::write_loop_start(texgen::read_loop_start(written, "written.json"), "hash") ==
                written,
            "the start of a loop is read as it was written");
}

}  // namespace foam::fuzz
