// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

namespace foam::texgen {
namespace {

/// Writes a gray PNG of `width` x 2 pixels. All pixels have the value `value` except the first one,
/// which has `first`.
void write_gray(const std::filesystem::path& path, int width, int value, int first) {
    Image<std::uint8_t> image(width, 2, 1);
    std::ranges::fill(image.samples(), static_cast<std::uint8_t>(value));
    image.samples()[0] = static_cast<std::uint8_t>(first);
    write_png(path, image.view());
}

class CompareCommand : public testing::Test {
  protected:
    CompareCommand() {
        write_gray(folder_.path() / "a.0001.png", 4, 100, 100);
        write_gray(folder_.path() / "a.0002.png", 4, 100, 100);
        write_gray(folder_.path() / "b.0001.png", 4, 100, 100);
        write_gray(folder_.path() / "b.0002.png", 4, 100, 151);  // differs by 0.2 of the range
        write_gray(folder_.path() / "wide.png", 5, 100, 100);
        write_file(folder_.path() / "torn.png", Bytes(10));
    }

    Outcome compare(const std::string& arguments) {
        return run_program("compare " + arguments, folder_);
    }

    TemporaryFolder folder_;
};

TEST_F(CompareCommand, ExitCodesAreThoseOfIdiff) {
    EXPECT_EQ(compare("a.0001.png b.0001.png").code, 0);
    EXPECT_EQ(compare("a.0002.png b.0002.png --warn 0.1 --fail 0.3").code, 1);
    EXPECT_EQ(compare("a.0002.png b.0002.png").code, 2);
    EXPECT_EQ(compare("a.0002.png b.0002.png --warn 0.3 --fail 0.3").code, 0);
    EXPECT_EQ(compare("a.0001.png wide.png").code, 3);
    EXPECT_EQ(compare("a.0001.png torn.png").code, 4);
    EXPECT_EQ(compare("a.0001.png none.png").code, 4);
}

TEST_F(CompareCommand, PrintsTheDifferenceOnOneLine) {
    EXPECT_EQ(compare("a.0002.png b.0002.png").out,
              "b.0002.png: failure, largest difference 0.2 in Y at 0,1, mean 0.025, 1 samples "
              "above the limits\n");
    EXPECT_EQ(compare("a.0001.png b.0001.png").out, "b.0001.png: same\n");
    EXPECT_EQ(compare("a.0001.png wide.png").out, "wide.png: different size or channels\n");
    EXPECT_EQ(compare("-q a.0002.png b.0002.png").out, "");
    const Outcome torn = compare("a.0001.png torn.png");
    EXPECT_EQ(torn.err, "foamtex: cannot read 'torn.png': malformed PNG: Not a PNG file\n");
}

TEST_F(CompareCommand, TheWorstFrameDecides) {
    EXPECT_EQ(compare("'a.####.png' 'b.####.png' --frames 1").code, 0);
    const Outcome both = compare("'a.####.png' 'b.####.png' --frames 1-2");
    EXPECT_EQ(both.code, 2);
    EXPECT_EQ(both.out.rfind("b.0001.png: same\nb.0002.png: failure", 0), 0U) << both.out;
    EXPECT_EQ(compare("'a.####.png' 'b.####.png' --frames 1-3").code, 4);
}

TEST_F(CompareCommand, SeveralFramesNeedAFrameNumberInBothNames) {
    const Outcome fixed = compare("'a.####.png' b.0001.png --frames 1-2");
    EXPECT_EQ(fixed.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(fixed.out, "");
    EXPECT_EQ(fixed.err,
              "foamtex: file name pattern 'b.0001.png': must contain a frame number (####, @@@@ or "
              "%04d) for 2 frames\n");
    EXPECT_EQ(compare("a.0001.png 'b.####.png' --frames 1-2").out, "");
    EXPECT_EQ(compare("a.0001.png b.0001.png --frames 1").code, 0);
}

TEST_F(CompareCommand, ShowsWhereTheyDiffer) {
    EXPECT_EQ(compare("a.0002.png b.0002.png --diff d.png").code, 2);
    const Image<std::uint16_t> shown = codes16(read_picture(folder_.path() / "d.png"));
    EXPECT_EQ(shown.row(0)[0], 65535);
    EXPECT_EQ(shown.row(0)[1], 0);
    EXPECT_EQ(compare("a.0001.png wide.png --diff e.png").code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "e.png"));
}

}  // namespace
}  // namespace foam::texgen
