// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

using Groups = std::vector<const ChannelGroup*>;

ChannelGroup row_group(const std::vector<std::uint8_t>& samples) {
    Image<std::uint8_t> image(static_cast<int>(samples.size()), 1, 1);
    std::copy(samples.begin(), samples.end(), image.samples().begin());
    return code_channels(std::move(image));
}

/// Returns the seam of the columns or of the rows, whichever has the larger ratio.
Seam worse(const TileSeams& seams) {
    return seams.columns.ratio() > seams.rows.ratio() ? seams.columns : seams.rows;
}

Seam seam_of_row(const std::vector<std::uint8_t>& samples, Difference difference) {
    const ChannelGroup group = row_group(samples);
    return worse(tile_seams(Groups{&group}, difference));
}

TEST(Steps, ASeamIsTheStepFromTheLastColumnToTheFirst) {
    const Seam seam = seam_of_row({10, 12, 15, 16}, Difference::Numbers);
    EXPECT_EQ(seam.across, 6.0);
    EXPECT_EQ(seam.largest_within, 3.0);
    EXPECT_EQ(seam.ratio(), 2.0);
    EXPECT_EQ(seam_of_row({1, 5, 1}, Difference::Numbers).ratio(), 0.0);
}

TEST(Steps, IdsAreTheSameOrNot) {
    const Seam seam = seam_of_row({1, 1, 200, 90}, Difference::Ids);
    EXPECT_EQ(seam.across, 1.0);
    EXPECT_EQ(seam.largest_within, 1.0);
}

TEST(Steps, SeamIsInfiniteWithoutOtherSteps) {
    EXPECT_TRUE(std::isinf(Seam({1.0, 0.0}).ratio()));
    EXPECT_EQ(Seam().ratio(), 0.0);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(std::isinf(Seam({infinity, infinity}).ratio()));
    EXPECT_TRUE(std::isinf(Seam({std::nan(""), 1.0}).ratio()));
    EXPECT_TRUE(std::isinf(Seam({1.0, infinity}).ratio()));
}

TEST(Steps, ASampleThatIsNoNumberIsNotIgnored) {
    Image<float> image(4, 1, 1);
    image.row(0)[2] = std::numeric_limits<float>::quiet_NaN();
    image.row(0)[3] = 1.0F;
    const ChannelGroup group{{"Y"}, SampleType::Float, image};
    const TileSeams seams = tile_seams(Groups{&group}, Difference::Numbers);
    EXPECT_EQ(seams.columns.across, 1.0);
    EXPECT_TRUE(std::isinf(seams.columns.ratio()));
}

// The rows have the values 0, 3, 6 and 9. The step across the border is from the last row to the
// first.
TEST(Steps, ASeamBetweenRowsCountsToo) {
    Image<std::uint8_t> image(2, 4, 1);
    for (int y = 0; y < 4; ++y) {
        image.row(y)[0] = image.row(y)[1] = static_cast<std::uint8_t>(3 * y);
    }
    const ChannelGroup group = code_channels(std::move(image));
    const Seam seam = worse(tile_seams(Groups{&group}, Difference::Numbers));
    EXPECT_EQ(seam.across, 9.0);
    EXPECT_EQ(seam.largest_within, 3.0);
}

// The channels of an EXR are separate groups. A step is the mean over all of them.
TEST(Steps, AreMeansOverAllChannels) {
    const ChannelGroup a = row_group({0, 4});
    const ChannelGroup b = row_group({0, 0});
    EXPECT_EQ(tile_seams(Groups{&a, &b}, Difference::Numbers).columns.across, 2.0);
    EXPECT_EQ(step_between(Groups{&a, &b}, Groups{&b, &b}, Difference::Numbers), 1.0);
    EXPECT_EQ(step_between(Groups{&a}, Groups{&b}, Difference::Ids), 0.5);
    EXPECT_EQ(step_between(Groups{&a}, Groups{&a}, Difference::Ids), 0.0);
}

// The seam of a frame without steps has the ratio 0, so a later NaN must count.
TEST(Steps, NoNumberIsTheWorstSeam) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    WorstSeam worst;
    worst.add({0.0, 0.0}, 1);
    EXPECT_EQ(worst.seam.ratio(), 0.0);
    worst.add({kNan, kNan}, 2);
    worst.add({5.0, 1.0}, 3);
    worst.add({kNan, 1.0}, 4);
    EXPECT_TRUE(std::isinf(worst.seam.ratio()));
    EXPECT_EQ(worst.frame, 2);
}

TEST(Steps, TheWorstSeamIsThatOfTheLargestStepAcrossIt) {
    WorstSeam worst;
    worst.add({2.0, 8.0}, 5);
    worst.add({4.0, 1.0}, 6);
    worst.add({3.0, 2.0}, 7);
    EXPECT_EQ(worst.seam.across, 4.0);
    EXPECT_EQ(worst.seam.largest_within, 8.0);
    EXPECT_EQ(worst.frame, 6);
}

TEST(Steps, ImagesOfOtherFormsAreInfinitelyDifferent) {
    const ChannelGroup a = row_group({0, 4});
    const ChannelGroup b = row_group({0, 4, 4});
    const ChannelGroup c{{"Y"}, SampleType::Float, Image<float>(2, 1, 1)};
    for (const ChannelGroup* other : {&b, &c}) {
        EXPECT_TRUE(std::isinf(step_between(Groups{&a}, Groups{other}, Difference::Numbers)));
    }
    EXPECT_TRUE(std::isinf(step_between(Groups{&a}, Groups{&a, &a}, Difference::Numbers)));
}

}  // namespace
}  // namespace foam::texgen
