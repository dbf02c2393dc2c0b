// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/picture_file.h"

#include "tests/support/temporary_folder.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

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
