// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/output_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(OutputOptions, LimitsHoldOnBothSides) {
    test::expect_limits(
        output_keys(),
        {{"frames_per_second", "0", "1", "1000", "1001"}, {"exr_level", "0", "1", "9", "10"}});
}

TEST(OutputOptions, ChoicesHaveTheirWords) {
    test::expect_words(output_keys(), "texts", {"written", "left-out"});
    test::expect_words(output_keys(), "png_compression", {"fast", "small", "none"});
    test::expect_words(output_keys(), "exr_compression", {"zip", "zips", "piz", "rle", "none"});
    test::expect_words(output_keys(), "exr_numbers", {"float", "half"});
    test::expect_words(output_keys(), "exr_layout", {"rows", "mip-levels"});
}

}  // namespace
}  // namespace foam::texgen
