// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/channel_row.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>

namespace foam::texgen {
namespace {

TEST(ChannelRow, WritesTheConvertedSamplesOfOneChannelWithoutGaps) {
    Image<float> image(2, 2, 3);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        image.samples()[k] = static_cast<float>(k);
    }
    std::array<std::uint16_t, 2> written{};
    ChannelRow<float>(image.view(), 1, 2)
        .write([](float number) { return static_cast<std::uint16_t>(10.0F * number); },
               std::as_writable_bytes(std::span(written)).data());
    EXPECT_EQ(written, (std::array<std::uint16_t, 2>{80, 110}));
}

}  // namespace
}  // namespace foam::texgen
