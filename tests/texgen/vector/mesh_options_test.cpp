// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/mesh_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(MeshOptions, LimitsHoldOnBothSides) {
    test::expect_limits(mesh_keys(),
                        {{"base_mm", "0.009", "0.01", "1000", "1000.1"},
                         {"relief_mm", "0.0009", "0.001", "1000", "1000.1"},
                         {"wall_mm", "0.009", "0.01", "1000", "1000.1"},
                         {"tolerance_mm", "0.0009", "0.001", "10", "10.1"}});
}

}  // namespace
}  // namespace foam::texgen
