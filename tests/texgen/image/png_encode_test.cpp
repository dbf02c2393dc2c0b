// SPDX-License-Identifier: Apache-2.0

#include "tests/support/sample_foams.h"
#include "tests/texgen/image/numbered.h"
#include "tests/texgen/image/png_chunks.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

using Text = std::vector<std::pair<std::string, std::string>>;

// Without compression and filter, the stream contains the rows unchanged, the top row first.
TEST(PngEncode, TheTopRowComesFirstInTheFile) {
    Image<std::uint8_t> image(2, 2, 1);
    image.row(0)[0] = 'a';  // bottom
    image.row(0)[1] = 'b';
    image.row(1)[0] = 'y';  // top
    image.row(1)[1] = 'z';
    const std::string data =
        chunk(encode_png(image.view(), {}, {.compression = Compression::None}), "IDAT");
    // The zlib header has 2 bytes, the header of the stored block 5 bytes. The filter byte 0
    // precedes each row.
    EXPECT_EQ(data.substr(7, 6), std::string("\0yz\0ab", 6));
}

TEST(PngEncode, SixteenBitSamplesHaveTheirHighByteFirst) {
    Image<std::uint16_t> image(2, 1, 1);
    image.row(0)[0] = 0x1234;
    image.row(0)[1] = 0x00ff;
    const Bytes stream = encode_png(image.view(), {}, {.compression = Compression::None});
    EXPECT_EQ(chunk(stream, "IDAT").substr(8, 4), std::string("\x12\x34\x00\xff", 4));
    EXPECT_EQ(chunk(stream, "IHDR"), (std::string{0, 0, 0, 2, 0, 0, 0, 1, 16, 0, 0, 0, 0}));
}

TEST(PngEncode, HoldsOneGroupOfCodes) {
    Picture picture{{code_channels(numbered_codes(3, 2, 3))}, {.color = true}};
    EXPECT_EQ(encode_png(picture), encode_png(numbered_codes(3, 2, 3).view(), {.color = true}));
    picture.groups.push_back(picture.groups.front());
    EXPECT_THROW(encode_png(picture), std::invalid_argument);
    const Picture numbers{{{{"Y"}, SampleType::Float, Image<float>(1, 1, 1)}}};
    EXPECT_THROW(encode_png(numbers), std::invalid_argument);
}

TEST(PngEncode, HeaderHasSizeDepthAndColorType) {
    // Width 3, height 2, 8 bits, then the color type of PNG's table 11.1.
    const std::map<int, char> types = {{1, 0}, {2, 4}, {3, 2}, {4, 6}};
    for (const auto& [channels, type] : types) {
        const std::string expected{0, 0, 0, 3, 0, 0, 0, 2, 8, type, 0, 0, 0};
        EXPECT_EQ(chunk(encode_png(numbered_codes(3, 2, channels).view()), "IHDR"), expected);
    }
}

TEST(PngEncode, ColorCarriesItsSpaceAndDataDoesNot) {
    const Image<std::uint8_t> image = numbered_codes(3, 2, 3);
    const Bytes color = encode_png(image.view(), {.color = true, .text = {}});
    EXPECT_EQ(chunk(color, "sRGB"), std::string(1, '\0'));                 // perceptual intent
    EXPECT_EQ(chunk(color, "gAMA"), std::string({0, 0, '\xb1', '\x8f'}));  // 45455
    EXPECT_EQ(chunk(color, "cHRM").size(), 32U);
    for (const auto& [type, content] : chunks_of(encode_png(image.view()))) {
        EXPECT_TRUE(type == "IHDR" || type == "IDAT" || type == "IEND") << type;
    }
}

TEST(PngEncode, TextIsLatinWherePossibleAndUtf8ElseAndKeepsItsOrder) {
    const Text text = {{"Preset", "[foam]\nbubbles = 4\n"}, {"Author", "Zoë 泡"}, {"Empty", ""}};
    const Bytes stream = encode_png(numbered_codes(1, 1, 1).view(), {.color = false, .text = text});
    EXPECT_EQ(chunk(stream, "tEXt"), std::string("Preset\0[foam]\nbubbles = 4\n", 26));
    EXPECT_NE(chunk(stream, "iTXt").find("Zoë 泡"), std::string::npos);
    EXPECT_EQ(decode_png(stream).metadata.text, text);
}

TEST(PngEncode, RejectsKeywordsThatPngForbids) {
    const Image<std::uint8_t> image(1, 1, 1);
    for (const std::string& key : {std::string(),
                                   std::string(80, 'k'),
                                   std::string(" a"),
                                   std::string("a  b"),
                                   std::string("ü")}) {
        EXPECT_THROW(encode_png(image.view(), {.color = false, .text = {{key, ""}}}),
                     std::invalid_argument)
            << key;
    }
}

TEST(PngEncode, RejectsPicturesThatPngCannotHold) {
    EXPECT_THROW(encode_png(ImageView<const std::uint8_t>()), std::invalid_argument);
    EXPECT_THROW(encode_png(Image<std::uint8_t>(1, 1, 5).view()), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
