// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/pictures/outline_file.h"

namespace foam::fuzz {

void fuzz_svg_outline(std::string_view input) {
    const auto parts = unless_rejected<InputError>([&] { return texgen::outlines_of_svg(input); });
    if (!parts) {
        return;
    }
    require(!parts->empty(), "an outline has a part");
    for (const Outline& part : *parts) {
        require(part.outer.size() >= 3, "a part has three corners");
        require(outline_area(part) > 0.0, "a part has an area");
    }
}

}  // namespace foam::fuzz
