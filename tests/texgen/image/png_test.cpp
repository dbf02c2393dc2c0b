#include "texgen/image/png.h"

#include "tests/texgen/temporary_folder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

using Text = std::vector<std::pair<std::string, std::string>>;

/// Type and content of the chunks of a stream, read as the PNG specification (section 5.3) lays
/// them out: 4 bytes length, 4 bytes type, content, 4 bytes check sum, after 8 bytes of signature.
std::vector<std::pair<std::string, std::string>> chunks_of(const Bytes& stream) {
    const std::string bytes(reinterpret_cast<const char*>(stream.data()), stream.size());
    std::vector<std::pair<std::string, std::string>> chunks;
    for (std::size_t at = 8; at < bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length * 256 + static_cast<unsigned char>(bytes[at + i]);
        }
        chunks.emplace_back(bytes.substr(at + 4, 4), bytes.substr(at + 8, length));
        at += length + 12;
    }
    return chunks;
}

std::string chunk(const Bytes& stream, const std::string& type) {
    for (const auto& [name, content] : chunks_of(stream)) {
        if (name == type) {
            return content;
        }
    }
    return "none";
}

Image<std::uint8_t> numbered(int width, int height, int channels) {
    Image<std::uint8_t> image(width, height, channels);
    std::uint8_t value = 0;
    for (std::uint8_t& sample : image.samples()) {
        sample = value++;
    }
    return image;
}

RC_GTEST_PROP(Png, PixelsAndTextsComeBack, ()) {
    const int width = *rc::gen::inRange(1, 20);
    const int height = *rc::gen::inRange(1, 20);
    const int channels = *rc::gen::inRange(1, 5);
    Image<std::uint8_t> image(width, height, channels);
    for (std::uint8_t& sample : image.samples()) {
        sample = *rc::gen::arbitrary<std::uint8_t>();
    }
    const PngMetadata metadata{.color = *rc::gen::arbitrary<bool>(), .text = {{"Seed", "1"}}};
    const PngEncoding encoding{.filter = static_cast<PngFilter>(*rc::gen::inRange(0, 6)),
                               .compression_level = *rc::gen::inRange(0, 10)};

    const PngImage back = decode_png(encode_png(image.view(), metadata, encoding));
    RC_ASSERT(back.pixels == image);
    RC_ASSERT(back.metadata.color == metadata.color);
    RC_ASSERT(back.metadata.text == metadata.text);
}

// Stored without compression or filter, the rows stand in the stream as they are: the top one
// first.
TEST(Png, TheTopRowComesFirstInTheFile) {
    Image<std::uint8_t> image(2, 2, 1);
    image.row(0)[0] = 'a';  // bottom
    image.row(0)[1] = 'b';
    image.row(1)[0] = 'y';  // top
    image.row(1)[1] = 'z';
    const std::string data = chunk(encode_png(image.view(), {}, {.compression_level = 0}), "IDAT");
    // A zlib header of 2 bytes, a stored block's of 5, then a filter byte 0 before each row.
    EXPECT_EQ(data.substr(7, 6), std::string("\0yz\0ab", 6));
}

TEST(Png, HeaderSaysSizeDepthAndKind) {
    // Width 3, height 2, 8 bits, then the colour type of PNG's table 11.1.
    const std::map<int, char> types = {{1, 0}, {2, 4}, {3, 2}, {4, 6}};
    for (const auto& [channels, type] : types) {
        const std::string expected{0, 0, 0, 3, 0, 0, 0, 2, 8, type, 0, 0, 0};
        EXPECT_EQ(chunk(encode_png(numbered(3, 2, channels).view()), "IHDR"), expected);
    }
}

TEST(Png, ColorCarriesItsSpaceAndDataDoesNot) {
    const Image<std::uint8_t> image = numbered(3, 2, 3);
    const Bytes color = encode_png(image.view(), {.color = true, .text = {}});
    EXPECT_EQ(chunk(color, "sRGB"), std::string(1, '\0'));                 // perceptual
    EXPECT_EQ(chunk(color, "gAMA"), std::string({0, 0, '\xb1', '\x8f'}));  // 45455
    EXPECT_EQ(chunk(color, "cHRM").size(), 32U);
    for (const auto& [type, content] : chunks_of(encode_png(image.view()))) {
        EXPECT_TRUE(type == "IHDR" || type == "IDAT" || type == "IEND") << type;
    }
}

TEST(Png, TextIsLatinWherePossibleAndUtf8ElseAndKeepsItsOrder) {
    const Text text = {{"Preset", "[foam]\nbubbles = 4\n"}, {"Author", "Zoë 泡"}, {"Empty", ""}};
    const Bytes stream = encode_png(numbered(1, 1, 1).view(), {.color = false, .text = text});
    EXPECT_EQ(chunk(stream, "tEXt"), std::string("Preset\0[foam]\nbubbles = 4\n", 26));
    EXPECT_NE(chunk(stream, "iTXt").find("Zoë 泡"), std::string::npos);
    EXPECT_EQ(decode_png(stream).metadata.text, text);
}

TEST(Png, RefusesKeywordsThatPngForbids) {
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

TEST(Png, RefusesPicturesThatPngCannotHold) {
    EXPECT_THROW(encode_png({}), std::invalid_argument);
    EXPECT_THROW(encode_png(Image<std::uint8_t>(1, 1, 5).view()), std::invalid_argument);
}

TEST(Png, EveryTruncationIsAnInputError) {
    const Bytes stream =
        encode_png(numbered(4, 4, 3).view(), {.color = true, .text = {{"a", "b"}}});
    for (std::size_t size = 0; size < stream.size(); ++size) {
        EXPECT_THROW(decode_png(std::span(stream).first(size)), InputError) << size;
    }
}

TEST(Png, ADamagedPixelStreamIsAnInputError) {
    Bytes stream = encode_png(numbered(4, 4, 3).view());
    stream[8 + 25 + 8 + 10] ^= std::byte{0xff};  // in the IDAT chunk, after signature and IHDR
    EXPECT_THROW(decode_png(stream), InputError);
}

/// The check sum of PNG's annex D, bit by bit.
std::uint32_t crc_of(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
        }
    }
    return ~crc;
}

void put(std::span<std::byte> place, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) {
        place[i] = static_cast<std::byte>(number >> (24 - 8 * i));
    }
}

// 900000 x 900000 pixels in a few bytes: refused before memory is asked for.
TEST(Png, AHeaderThatPromisesTooMuchIsAnInputError) {
    Bytes stream = encode_png(numbered(1, 1, 3).view());
    const std::span bytes(stream);
    put(bytes.subspan(16, 4), 900'000);  // the header's content starts after 8 + 8 bytes
    put(bytes.subspan(20, 4), 900'000);
    put(bytes.subspan(29, 4), crc_of(bytes.subspan(12, 17)));
    EXPECT_THROW(decode_png(stream), InputError);
}

TEST(Png, FilesAreReadAsWritten) {
    const TemporaryFolder folder;
    const Image<std::uint8_t> image = numbered(5, 7, 3);
    write_png(folder.path() / "a.png", image.view(), {.color = true, .text = {{"Seed", "9"}}});
    const PngImage back = read_png(folder.path() / "a.png");
    EXPECT_EQ(back.pixels, image);
    EXPECT_EQ(back.metadata.text, (Text{{"Seed", "9"}}));
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.png"});
}

TEST(Png, AMalformedFileIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.png";
    write_file(path, Bytes(20));
    try {
        read_png(path);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot read '" + path.string() + "': malformed PNG: Not a PNG file");
    }
}

/// The nearest of 60 sites gives a pixel its flat colour: the cells of a foam without films.
Image<std::uint8_t> flat_cells() {
    const auto site = [](int i, int k) { return (i * (k == 0 ? 97 : 61) + i * i * 31) % 256; };
    Image<std::uint8_t> image(256, 256, 3);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            int best = 0;
            const auto distance = [&](int i) { return std::hypot(site(i, 0) - x, site(i, 1) - y); };
            for (int i = 1; i < 60; ++i) {
                best = distance(i) < distance(best) ? i : best;
            }
            for (const int channel : {0, 1, 2}) {
                image.pixel(x, y)[static_cast<std::size_t>(channel)] =
                    static_cast<std::uint8_t>(best * (7 + 13 * channel));
            }
        }
    }
    return image;
}

// Why None is the default.
TEST(Png, FlatCellsAreSmallestWithoutFilter) {
    const Image<std::uint8_t> image = flat_cells();
    const std::size_t none = encode_png(image.view()).size();
    for (const PngFilter filter : {PngFilter::Sub,
                                   PngFilter::Up,
                                   PngFilter::Average,
                                   PngFilter::Paeth,
                                   PngFilter::Adaptive}) {
        EXPECT_LT(none, encode_png(image.view(), {}, {.filter = filter}).size())
            << static_cast<int>(filter);
    }
}

}  // namespace
}  // namespace foam::texgen
