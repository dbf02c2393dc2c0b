#include "texgen/image/png_palette.h"

#include "tests/texgen/image/png_chunks.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace foam::texgen {
namespace {

// The content of a palette image of three pixels: PNG's colour type 3, a palette in the order of
// appearance from the top left, opacities only where the picture has them.
TEST(PngPalette, FewColorsBecomeAPalette) {
    Image<std::uint8_t> image(2, 2, 4);
    std::ranges::copy(std::string("abc\x10"), image.pixel(0, 1).begin());
    std::ranges::copy(std::string("def\xff"), image.pixel(1, 1).begin());
    std::ranges::copy(std::string("abc\x10"), image.pixel(0, 0).begin());
    std::ranges::copy(std::string("ghi\x20"), image.pixel(1, 0).begin());
    const PngEncoding encoding{.compression = Compression::None, .palette = true};
    const Bytes stream = encode_png(image.view(), {}, encoding);
    EXPECT_EQ(chunk(stream, "IHDR"), (std::string{0, 0, 0, 2, 0, 0, 0, 2, 8, 3, 0, 0, 0}));
    EXPECT_EQ(chunk(stream, "PLTE"), "abcdefghi");
    EXPECT_EQ(chunk(stream, "tRNS"), "\x10\xff\x20");
    EXPECT_EQ(chunk(stream, "IDAT").substr(7, 6), std::string("\0\0\1\0\0\2", 6));
    EXPECT_EQ(decode_png(stream).pixels, image);
}

// 256 colours fit a palette, 257 do not.
TEST(PngPalette, TooManyColorsStayAsTheyAre) {
    Image<std::uint8_t> image(257, 1, 3);
    for (int x = 0; x < 257; ++x) {
        image.pixel(x, 0)[0] = static_cast<std::uint8_t>(x % 256);
        image.pixel(x, 0)[1] = x == 256 ? 1 : 0;
    }
    const PngEncoding encoding{.palette = true};
    const Bytes colors = encode_png(image.view(), {}, encoding);
    EXPECT_EQ(chunk(colors, "PLTE"), "none");
    EXPECT_EQ(decode_png(colors).pixels, image);
    image.pixel(256, 0)[1] = 0;
    const Bytes indexed = encode_png(image.view(), {}, encoding);
    EXPECT_EQ(chunk(indexed, "PLTE").size(), 3U * 256U);
    EXPECT_EQ(decode_png(indexed).pixels, image);
}

// Colours that differ in a single channel are different ones, opacity included.
TEST(PngPalette, KnowsColorsApart) {
    Image<std::uint8_t> image(5, 1, 4);
    for (int x = 0; x < 4; ++x) {
        image.pixel(x, 0)[static_cast<std::size_t>(x)] = 9;
    }
    const auto indexed = with_palette(image.view());
    ASSERT_TRUE(indexed.has_value());
    EXPECT_EQ(indexed->palette,
              (std::vector<PaletteColor>{
                  {9, 0, 0, 0}, {0, 9, 0, 0}, {0, 0, 9, 0}, {0, 0, 0, 9}, {0, 0, 0, 0}}));
    EXPECT_TRUE(std::ranges::equal(indexed->indices.samples(), std::vector{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace foam::texgen
