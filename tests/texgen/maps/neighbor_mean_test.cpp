// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/neighbor_mean.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace foam::texgen {
namespace {

// In a honeycomb of 4 x 4 hexagons every bubble has six neighbors with films of equal length.
TEST(NeighborMean, SpreadsAValueEvenlyOverSixNeighbors) {
    const Frame frame = snapshot(honeycomb(4, 4), 1);
    PerBubble<double> values(16, 0.0);
    values[5] = 12.0;
    average_with_neighbors(frame, 1, values);
    EXPECT_NEAR(values[5], 6.0, 1e-12);
    int neighbors = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (k != 5 && values[k] > 0.0) {
            EXPECT_NEAR(values[k], 1.0, 1e-12);
            ++neighbors;
        }
    }
    EXPECT_EQ(neighbors, 6);
}

TEST(NeighborMean, EqualValuesStay) {
    const Frame frame = snapshot(test::patch_foam(30, 2), 1);
    PerBubble<double> values(frame.bubbles.size() + frame.lone_bubbles.size(), 3.0);
    average_with_neighbors(frame, 5, values);
    for (const double value : values) {
        EXPECT_DOUBLE_EQ(value, 3.0);
    }
}

TEST(NeighborMean, NoRoundsChangeNothing) {
    const Frame frame = snapshot(honeycomb(2, 2), 1);
    PerBubble<double> values{1.0, 2.0, 3.0, 4.0};
    average_with_neighbors(frame, 0, values);
    EXPECT_EQ(values, (PerBubble<double>{1.0, 2.0, 3.0, 4.0}));
}

}  // namespace
}  // namespace foam::texgen
