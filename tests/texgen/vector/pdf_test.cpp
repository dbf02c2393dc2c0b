// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/pdf.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

Drawing disk() {
    Drawing drawing{.width = 254.0, .height = 127.0, .title = "a disk"};
    drawing.layers.push_back(
        {.name = "bubbles",
         .shapes = {
             {.kind = "bubble", .chains = {circle({50.0, 50.0}, 20.0)}, .fill = "#ff0000"}}});
    return drawing;
}

// 254 mm are 10 inches of 72 points.
TEST(Pdf, HasOnePageOfTheSizeOfTheDrawing) {
    const std::string text = to_pdf(disk());
    EXPECT_TRUE(text.starts_with("%PDF-"));
    EXPECT_NE(text.find("/MediaBox [ 0 0 720 360 ]"), std::string::npos);
    EXPECT_NE(text.find("/Count 1"), std::string::npos);
}

TEST(Pdf, TheSameDrawingGivesTheSameBytes) {
    EXPECT_EQ(to_pdf(disk()), to_pdf(disk()));
}

}  // namespace
}  // namespace foam::texgen
