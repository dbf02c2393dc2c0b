// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/earlier_sheets.h"

#include "tests/fuzz/fuzz_target.h"

#include <nlohmann/json.hpp>

namespace foam::fuzz {

// Parses the input as the JSON file of an earlier flipbook. A new flipbook is about to replace it.
void fuzz_earlier_sheets(std::string_view input) {
    texgen::Json description{{"format", "foamtex-flipbook"},
                             {"frames", 4},
                             {"images", {{{"file", "height.png"}, {"map", "height"}}}}};
    texgen::keep_earlier_sheets(description, input, "tests");
    require(description["images"][0]["file"] == "height.png", "the new sheet stays first");
    require(texgen::Json::accept(texgen::indented(description)), "the description is JSON");
}

}  // namespace foam::fuzz
