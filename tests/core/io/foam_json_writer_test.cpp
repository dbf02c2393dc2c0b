// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/collapse.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/core/foams.h"
#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

using test::kSmallState;

Foam read(const std::string& text) {
    return read_foam_json(text, "a.json");
}

TEST(FoamJsonWriter, WritesOneElementALine) {
    EXPECT_EQ(write_foam_json(read_evolver(test::kSmallTorus, "").foam), kSmallState);
}

TEST(FoamJsonWriter, ClosesDeadSlots) {
    Foam foam = test::honeycomb_around(3);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{5}, counts));
    const Foam again = read(write_foam_json(foam));
    compact(foam);
    EXPECT_TRUE(test::are_same(again, foam));
}

}  // namespace
}  // namespace foam
