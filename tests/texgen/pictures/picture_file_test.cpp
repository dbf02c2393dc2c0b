// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/picture_file.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

TEST(PictureFile, ReadsThePictureThatAValueNames) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "x.png").string();
    write_png(path, Image<std::uint8_t>(3, 2, 1).view());
    PictureFile file;
    ASSERT_TRUE(PictureFiles{}.read({path}, file));
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(file.picture->width(), 3);
    EXPECT_EQ(file.picture->height(), 2);
    EXPECT_EQ(PictureFiles{}.file(file)->hash, file.hash);
    EXPECT_EQ(file.hash.size(), 32U);
    EXPECT_EQ(PictureFiles{}.write(file), Value{path});
    ASSERT_TRUE(PictureFiles{}.read({std::string()}, file));
    EXPECT_FALSE(file.is_set());
    EXPECT_FALSE(PictureFiles{}.file(file).has_value());
}

// The numbers are the first column of the matrix from linear sRGB to ACEScg with the Bradford
// transform, as programs for colors publish it: the color red.
TEST(PictureFile, ColorsHaveThePrimariesOfSrgb) {
    const TemporaryFolder folder;
    Image<float> rgb(1, 1, 3);
    std::ranges::copy(std::vector{0.613097F, 0.070194F, 0.020616F}, rgb.samples().begin());
    Picture picture{{{{"R", "G", "B"}, SampleType::Float, std::move(rgb)}}};
    picture.metadata.color = true;
    const auto read = [&](Primaries primaries) {
        picture.metadata.primaries = primaries;
        const std::string path = (folder.path() / "x.exr").string();
        write_file(path, encode_exr(picture));
        return read_picture_file(path);
    };
    const PictureFile converted = read(Primaries::AcesCg);
    const LinearRgb red = pixel_of(*converted.picture, 0, 0).color;
    EXPECT_NEAR(red.r, 1.0, 1e-3);
    EXPECT_NEAR(red.g, 0.0, 1e-3);
    EXPECT_NEAR(red.b, 0.0, 1e-3);
    const PictureFile same = read(Primaries::Srgb);
    EXPECT_NEAR(pixel_of(*same.picture, 0, 0).color.r, 0.6131, 1e-4);
    EXPECT_NE(same.hash, converted.hash);
}

TEST(PictureFile, SaysWhyAFileCannotBeRead) {
    const TemporaryFolder folder;
    const std::string missing = (folder.path() / "missing.png").string();
    PictureFile file{"before", nullptr, ""};
    EXPECT_FALSE(PictureFiles{}.read({missing}, file));
    EXPECT_EQ(file.path, "before");
    EXPECT_EQ(PictureFiles{}.fault({missing}),
              "cannot read '" + missing + "': No such file or directory");
    EXPECT_FALSE(PictureFiles{}.read({3.0}, file));
    EXPECT_EQ(PictureFiles{}.fault({3.0}), "");
    EXPECT_TRUE(is_picture_name("a.exr"));
    EXPECT_FALSE(is_picture_name("gradient"));
}

}  // namespace
}  // namespace foam::texgen
