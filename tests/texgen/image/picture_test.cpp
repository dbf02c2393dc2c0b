// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

ChannelGroup numbers(std::vector<std::string> names) {
    const auto channels = static_cast<int>(names.size());
    return {std::move(names), SampleType::Float, Image<float>(2, 1, channels)};
}

TEST(Picture, CodesAreNamedByTheirNumber) {
    const std::vector<std::string> names = {"Y", "YA", "RGB", "RGBA"};
    for (int channels = 1; channels <= 4; ++channels) {
        const ChannelGroup group = code_channels(Image<std::uint16_t>(2, 3, channels));
        std::string joined;
        for (const std::string& name : group.names) {
            joined += name;
        }
        EXPECT_EQ(joined, names.at(static_cast<std::size_t>(channels - 1)));
        EXPECT_EQ(group.type, SampleType::Uint16);
        EXPECT_EQ(group.channels(), channels);
    }
}

TEST(Picture, ChannelsAreInTheOrderOfTheirNames) {
    const Picture picture{{numbers({"R", "G", "B"}), numbers({"A"})}};
    std::string names;
    for (const PictureChannel& channel : channels_of(picture)) {
        names += channel.name;
    }
    EXPECT_EQ(names, "ABGR");
    EXPECT_EQ(channels_of(picture)[3].index, 0);
    EXPECT_EQ(picture.width(), 2);
    EXPECT_EQ(picture.height(), 1);
}

TEST(Picture, ALayerHasItsGroupsAndThoseWithoutALayer) {
    const Picture picture{{numbers({"film.Y"}), numbers({"albedo.R"}), numbers({"filmy.Y"})}};
    const std::vector<const ChannelGroup*> film = groups_of(picture, "film");
    ASSERT_EQ(film.size(), 1U);
    EXPECT_EQ(film[0], &picture.groups[0]);
    EXPECT_EQ(groups_of({{numbers({"Y"})}}, "film").size(), 1U);
}

// A name of a channel in a foreign EXR may have several dots.
TEST(Picture, ALayerIsTheTextBeforeTheLastDot) {
    EXPECT_EQ(layer_of("Y"), "");
    EXPECT_EQ(layer_of("film.Y"), "film");
    EXPECT_EQ(layer_of("a.b.Y"), "a.b");
    const Picture picture{{numbers({"a.b.Y"}), numbers({"a.Y"})}};
    EXPECT_EQ(groups_of(picture, "a"), (std::vector{&picture.groups[1]}));
    EXPECT_EQ(groups_of(picture, "a.b"), (std::vector{&picture.groups[0]}));
}

TEST(Picture, TheLargestCodeIsOne) {
    Image<std::uint8_t> codes(3, 1, 2);
    std::ranges::copy(std::vector{0, 1, 51, 2, 255, 3}, codes.samples().begin());
    const Picture picture{{code_channels(codes)}};
    const PictureChannel gray = channels_of(picture)[1];
    EXPECT_EQ(gray.name, "Y");
    std::vector<double> row(3);
    read_numbers(gray, 0, row);
    EXPECT_EQ(row, (std::vector{0.0, 0.2, 1.0}));
    Image<std::uint32_t> ids(3, 1, 1);
    std::ranges::copy(std::vector{7, 8, 9}, ids.samples().begin());
    const Picture labels{{{{"Y"}, SampleType::Uint32, ids}}};
    read_numbers(channels_of(labels)[0], 0, row);
    EXPECT_EQ(row, (std::vector{7.0, 8.0, 9.0}));
}

}  // namespace
}  // namespace foam::texgen
