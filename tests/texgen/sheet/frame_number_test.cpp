// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/frame_number.h"

#include "texgen/sheet/contact_sheet.h"
#include "texgen/sheet/display_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(FrameNumber, DrawsDigits) {
    Image<std::uint8_t> image(11, 7, 1);
    draw_number(image.view(), 0, 0, 17, 1);
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
    EXPECT_EQ(number_width(7), 5);
    EXPECT_EQ(number_width(1017), 23);
}

}  // namespace
}  // namespace foam::texgen
