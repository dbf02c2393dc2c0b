// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/pictures/outline_file.h"

namespace foam::fuzz {

namespace {

// A small grid, so that drawing and tracing do not take most of the time of a run.
constexpr double kGridPoints = 4096.0;

}  // namespace

void fuzz_svg_outline(std::string_view input) {
    const auto parts =
        unless_rejected<InputError>([&] { return texgen::outlines_of_svg(input, kGridPoints); });
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
