// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/label.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Label, DrawsLetters) {
    Image<std::uint8_t> image(11, 7, 1);
    draw_label(image.view(), 0, 0, "17", 1);
    std::string drawn;
    for (int y = 6; y >= 0; --y) {
        for (const std::uint8_t sample : image.row(y)) {
            drawn += sample == 1 ? '#' : '.';
        }
        drawn += '\n';
    }
    EXPECT_EQ(drawn,
              "..#...#####\n"
              ".##.......#\n"
              "..#......#.\n"
              "..#.....#..\n"
              "..#.....#..\n"
              "..#....#...\n"
              ".###...#...\n");
    EXPECT_EQ(label_width("7"), 5);
    EXPECT_EQ(label_width("1017"), 23);
}

TEST(Label, DrawsSquaresIfMagnified) {
    Image<std::uint8_t> image(15, 21, 1);
    draw_label(image.view(), 0, 0, "1", 1, 3);
    Image<std::uint8_t> small(5, 7, 1);
    draw_label(small.view(), 0, 0, "1", 1);
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 15; ++x) {
            EXPECT_EQ(image.pixel(x, y)[0], small.pixel(x / 3, y / 3)[0]) << x << ' ' << y;
        }
    }
}

TEST(Label, HasADifferentPictureForEveryCharacter) {
    std::set<std::string> pictures;
    for (char character = ' '; character <= '~'; ++character) {
        Image<std::uint8_t> image(kLetterWidth, kLetterHeight, 1);
        draw_label(image.view(), 0, 0, std::string(1, character), 1);
        pictures.emplace(image.samples().begin(), image.samples().end());
    }
    EXPECT_EQ(pictures.size(), 95U);
}

using Lines = std::vector<std::string>;

// A character is 6 pixels wide, the last one 5: eleven characters need 65 pixels, and 60 pixels are
// enough for ten.
TEST(Label, IsWrappedAtSeparators) {
    EXPECT_EQ(wrapped_label("foam.seed=1", 65), Lines{"foam.seed=1"});
    EXPECT_EQ(wrapped_label("foam.seed=1", 64), (Lines{"foam.seed=", "1"}));
    EXPECT_EQ(wrapped_label("foam.seed=1", 130, 2), Lines{"foam.seed=1"});
    EXPECT_EQ(wrapped_label("drift=[0.25, 0.55]", 65), (Lines{"drift=", "[0.25,", "0.55]"}));
    EXPECT_EQ(wrapped_label("abcdefgh", 17), (Lines{"abc", "def", "gh"}));
    EXPECT_EQ(wrapped_label("ab", 1), (Lines{"a", "b"}));
    EXPECT_EQ(wrapped_label("", 60), Lines{""});
    // A space may follow directly after a full line.
    EXPECT_EQ(wrapped_label("abc def", 17), (Lines{"abc", "def"}));
    EXPECT_EQ(wrapped_label("abc   ", 17), Lines{"abc"});
    EXPECT_EQ(wrapped_label("   ", 5), Lines{""});
}

TEST(Label, DrawsOtherCharactersAsQuestionMarks) {
    Image<std::uint8_t> image(kLetterWidth, kLetterHeight, 1);
    draw_label(image.view(), 0, 0, "\xc3", 1);
    Image<std::uint8_t> mark(kLetterWidth, kLetterHeight, 1);
    draw_label(mark.view(), 0, 0, "?", 1);
    EXPECT_EQ(image, mark);
}

}  // namespace
}  // namespace foam::texgen
