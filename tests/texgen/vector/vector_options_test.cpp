// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/vector_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(VectorOptions, LimitsHoldOnBothSides) {
    test::expect_limits(vector_keys(),
                        {{"width_mm", "0.09", "0.1", "100000", "100001"},
                         {"wall_width", "0.0009", "0.001", "1000", "1000.1"}});
}

}  // namespace
}  // namespace foam::texgen
