// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/contact_sheet.h"

#include "texgen/sheet/display_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::uint8_t kFilled = 255;

Image<std::uint8_t> filled(int width, int height) {
    Image<std::uint8_t> image(width, height, 3);
    std::ranges::fill(image.samples(), kFilled);
    return image;
}

int count(const Image<std::uint8_t>& image, std::uint8_t code) {
    return static_cast<int>(std::ranges::count(image.samples(), code));
}

// Twelve squares are arranged in 4 columns and 3 rows.
TEST(ContactSheet, ShowsEveryThumbnailWhole) {
    std::vector<Thumbnail> thumbnails(12, {filled(40, 40), {{"8"}}});
    const Image<std::uint8_t> sheet = contact_sheet(thumbnails);
    EXPECT_EQ(count(sheet, kFilled), 12 * 3 * 40 * 40);
    EXPECT_GT(sheet.width(), 4 * 40);
    EXPECT_LT(sheet.width(), 5 * 40 + 40);
    EXPECT_GT(sheet.height(), 3 * 40);
    for (const int x : {0, sheet.width() - 1}) {
        EXPECT_EQ(sheet.pixel(x, sheet.height() / 2)[0], kBackgroundGray);
    }
}

// The digit 8 has 17 pixels with three samples each. All other samples belong to thumbnails or to
// the ground.
TEST(ContactSheet, LabelsEveryThumbnail) {
    std::vector<Thumbnail> thumbnails(3, {filled(20, 10), {{"8"}}});
    const Image<std::uint8_t> sheet = contact_sheet(thumbnails);
    const auto all = static_cast<int>(sheet.samples().size());
    EXPECT_EQ(all - count(sheet, kBackgroundGray) - count(sheet, kFilled), 3 * 3 * 17);
}

TEST(ContactSheet, HasTheGivenColumns) {
    std::vector<Thumbnail> thumbnails(6, {filled(40, 40), {{"a"}, {"b"}}});
    const Image<std::uint8_t> sheet = contact_sheet(thumbnails, {.columns = 2, .magnification = 2});
    EXPECT_GT(sheet.width(), 2 * 40);
    EXPECT_LT(sheet.width(), 3 * 40);
    EXPECT_GT(sheet.height(), 3 * (40 + 2 * 14));
}

// "size=0.25" has 9 characters and is 53 pixels wide: it needs two lines under 40 pixels. Each line
// is 12 pixels high.
TEST(ContactSheet, WrapsLongLabels) {
    const auto height_with = [](const std::string& second) {
        return contact_sheet(
                   std::vector<Thumbnail>{{filled(40, 40), {{"8"}}}, {filled(40, 40), {{second}}}})
            .height();
    };
    EXPECT_EQ(height_with("size=0.25"), height_with("8") + 12);
}

// Two squares of 7 x 7 pixels fit after a letter; 20 colors share the width of 40 pixels.
TEST(ContactSheet, ShowsColors) {
    const Srgb8 blue{0, 0, 200};
    const auto drawn = [&](std::size_t colors) {
        const ThumbnailLabel label{"c", std::vector<Srgb8>(colors, blue)};
        return contact_sheet(std::vector<Thumbnail>{{filled(40, 40), {label}}});
    };
    EXPECT_EQ(count(drawn(2), 200), 2 * 7 * 7);
    EXPECT_EQ(count(drawn(20), 200), 40 * 7);
    EXPECT_EQ(drawn(20).height(), drawn(2).height() + 12);
}

// Of 60 colors below 16 pixels, 16 are drawn, each one pixel wide: the first one, then about every
// fourth one.
TEST(ContactSheet, ShowsAsManyColorsAsFit) {
    ThumbnailLabel label{"c"};
    for (std::uint8_t k = 0; k < 60; ++k) {
        label.colors.push_back({k, 0, 0});
    }
    const Image<std::uint8_t> sheet =
        contact_sheet(std::vector<Thumbnail>{{filled(16, 16), {label}}});
    std::vector<int> reds;
    for (int x = 10; x < 10 + 16; ++x) {
        EXPECT_EQ(sheet.pixel(x, 10)[1], 0);
        reds.push_back(sheet.pixel(x, 10)[0]);
    }
    EXPECT_EQ(reds, (std::vector{0, 3, 7, 11, 15, 18, 22, 26, 30, 33, 37, 41, 45, 48, 52, 56}));
    EXPECT_EQ(sheet.width(), 16 + 2 * 10);
}

TEST(ContactSheet, NeedsAFrame) {
    EXPECT_THROW(contact_sheet({}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
