// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/stl.h"

#include <gtest/gtest.h>

#include <cstring>

namespace foam::texgen {
namespace {

template <class Number>
Number number_at(const std::string& file, std::size_t at) {
    Number number;
    std::memcpy(&number, file.data() + at, sizeof number);
    return number;
}

// The layout of binary STL: 80 bytes, the number of triangles, and for each triangle the normal,
// three corners (12 floats) and 2 bytes.
TEST(Stl, HasTheLayoutOfBinaryFiles) {
    const Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    const std::string file = to_stl(mesh, "a title");
    ASSERT_EQ(file.size(), 80U + 4U + 2U * 50U);
    EXPECT_TRUE(file.starts_with("foamtex mesh in millimeters: a title "));
    EXPECT_EQ(number_at<std::uint32_t>(file, 80), 2U);
    EXPECT_EQ(number_at<float>(file, 84 + 8), 1.0F);        // z of the normal
    EXPECT_EQ(number_at<float>(file, 84 + 24), 2.0F);       // x of the second corner
    EXPECT_EQ(number_at<float>(file, 84 + 40), 2.0F);       // y of the third corner
    EXPECT_EQ(number_at<float>(file, 84 + 50 + 8), -1.0F);  // z of the second normal
    EXPECT_EQ(number_at<std::uint16_t>(file, 84 + 48), 0U);
}

TEST(Stl, ALongTitleIsCutAndOtherCharactersAreReplaced) {
    const std::string file = to_stl({}, std::string(200, 'x'));
    EXPECT_EQ(file.size(), 84U);
    EXPECT_EQ(file[78], 'x');
    EXPECT_EQ(file[79], '\0');
    EXPECT_TRUE(to_stl({}, "f\xC3\xB6n").starts_with("foamtex mesh in millimeters: f??n"));
}

}  // namespace
}  // namespace foam::texgen
