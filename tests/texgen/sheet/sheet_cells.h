// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {

/// The gutter of the sheets in tests, pixels.
inline constexpr int kGutter = 3;

/// Expects that a cell of a sheet, with its gutter, shows the frame repeated as a tile.
template <class Sample>
void expect_cell(const Image<Sample>& sheet, int column, int row, const Image<Sample>& frame) {
    const int left = column * (frame.width() + 2 * kGutter);
    const int bottom = sheet.height() - (row + 1) * (frame.height() + 2 * kGutter);
    for (int y = 0; y < frame.height() + 2 * kGutter; ++y) {
        for (int x = 0; x < frame.width() + 2 * kGutter; ++x) {
            const auto expected = frame.pixel((x - kGutter + frame.width()) % frame.width(),
                                              (y - kGutter + frame.height()) % frame.height());
            ASSERT_TRUE(std::ranges::equal(sheet.pixel(left + x, bottom + y), expected))
                << column << " " << row << ": " << x << " " << y;
        }
    }
}

}  // namespace foam::texgen
