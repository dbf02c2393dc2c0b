#include "texgen/image/png.h"

#include "tests/support/raster_frames.h"
#include "tests/texgen/image/png_chunks.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/maps/albedo.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

using Text = std::vector<std::pair<std::string, std::string>>;

Image<std::uint8_t> numbered(int width, int height, int channels) {
    Image<std::uint8_t> image(width, height, channels);
    std::uint8_t value = 0;
    for (std::uint8_t& sample : image.samples()) {
        sample = value++;
    }
    return image;
}

template <class Sample>
Image<Sample> any_image() {
    const int width = *rc::gen::inRange(1, 20);
    const int height = *rc::gen::inRange(1, 20);
    Image<Sample> image(width, height, *rc::gen::inRange(1, 5));
    for (Sample& sample : image.samples()) {
        sample = *rc::gen::arbitrary<Sample>();
    }
    return image;
}

PngEncoding any_encoding() {
    return {.filter = static_cast<PngFilter>(*rc::gen::inRange(0, 5)),
            .compression = static_cast<Compression>(*rc::gen::inRange(0, 3)),
            .palette = *rc::gen::arbitrary<bool>()};
}

RC_GTEST_PROP(Png, PixelsAndTextsComeBack, ()) {
    const auto image = any_image<std::uint8_t>();
    const PngMetadata metadata{.color = *rc::gen::arbitrary<bool>(), .text = {{"Seed", "1"}}};
    const PngImage back = decode_png(encode_png(image.view(), metadata, any_encoding()));
    RC_ASSERT(back.pixels == image);
    RC_ASSERT(back.metadata.color == metadata.color);
    RC_ASSERT(back.metadata.text == metadata.text);
}

RC_GTEST_PROP(Png, SixteenBitPixelsComeBack, ()) {
    const auto image = any_image<std::uint16_t>();
    const Bytes stream = encode_png(image.view(), {}, any_encoding());
    RC_ASSERT(decode_png16(stream).pixels == image);
}

// Stored without compression or filter, the rows stand in the stream as they are: the top one
// first.
TEST(Png, TheTopRowComesFirstInTheFile) {
    Image<std::uint8_t> image(2, 2, 1);
    image.row(0)[0] = 'a';  // bottom
    image.row(0)[1] = 'b';
    image.row(1)[0] = 'y';  // top
    image.row(1)[1] = 'z';
    const std::string data =
        chunk(encode_png(image.view(), {}, {.compression = Compression::None}), "IDAT");
    // A zlib header of 2 bytes, a stored block's of 5, then a filter byte 0 before each row.
    EXPECT_EQ(data.substr(7, 6), std::string("\0yz\0ab", 6));
}

TEST(Png, SixteenBitSamplesHaveTheirHighByteFirst) {
    Image<std::uint16_t> image(2, 1, 1);
    image.row(0)[0] = 0x1234;
    image.row(0)[1] = 0x00ff;
    const Bytes stream = encode_png(image.view(), {}, {.compression = Compression::None});
    EXPECT_EQ(chunk(stream, "IDAT").substr(8, 4), std::string("\x12\x34\x00\xff", 4));
    EXPECT_EQ(chunk(stream, "IHDR"), (std::string{0, 0, 0, 2, 0, 0, 0, 1, 16, 0, 0, 0, 0}));
}

TEST(Png, EightBitsAreReadAsSixteenAndNotTheOtherWayRound) {
    Image<std::uint8_t> image(3, 1, 1);
    image.row(0)[0] = 255;
    image.row(0)[1] = 1;
    const PngImage16 wide = decode_png16(encode_png(image.view()));
    EXPECT_EQ(wide.pixels.row(0)[0], 65535);
    EXPECT_EQ(wide.pixels.row(0)[1], 257);
    EXPECT_EQ(wide.pixels.row(0)[2], 0);
    EXPECT_THROW(decode_png(encode_png(wide.pixels.view())), InputError);
}

// 900 x 700 RGB pixels are compressed in four parts: each its own IDAT chunk.
TEST(Png, TheBytesDoNotDependOnTheNumberOfThreads) {
    Image<std::uint8_t> image(900, 700, 3);
    unsigned state = 1;
    for (std::uint8_t& sample : image.samples()) {
        state = state * 1664525 + 1013904223;
        sample = static_cast<std::uint8_t>(state >> 30);
    }
    const Bytes one = encode_png(image.view());
    const auto chunks = chunks_of(one);
    EXPECT_EQ(std::ranges::count(chunks, "IDAT", &decltype(chunks)::value_type::first), 4);
    EXPECT_EQ(decode_png(one).pixels, image);
    for (const int threads : {0, 2, 3, 7}) {
        EXPECT_EQ(encode_png(image.view(), {}, {.threads = threads}), one) << threads;
    }
}

// A picture of another size, depth and palette in between leaves nothing behind.
TEST(Png, AnEncoderGivesTheSameBytesAgain) {
    PngEncoder encoder;
    const Image<std::uint8_t> image = numbered(300, 200, 3);
    const PngMetadata metadata{.color = true, .text = {{"Seed", "1"}}};
    const std::span<const std::byte> first = encoder.encode(image.view(), metadata);
    const Bytes expected(first.begin(), first.end());
    encoder.encode(Image<std::uint16_t>(900, 700, 2).view(), {}, {.filter = PngFilter::Paeth});
    encoder.encode(numbered(5, 5, 4).view(), {}, {.palette = true});
    const std::span<const std::byte> again = encoder.encode(image.view(), metadata);
    EXPECT_TRUE(std::ranges::equal(again, expected));
    EXPECT_EQ(encode_png(image.view(), metadata), expected);
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
    EXPECT_THROW(encode_png(ImageView<const std::uint8_t>()), std::invalid_argument);
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

/// Flat cells with and without films between them, as a bake draws them.
std::vector<Image<std::uint8_t>> flat_cells() {
    const Frame frame = test::fitted_frame(test::bent_foam(100, 0.3, 1), 256, 256);
    std::vector<Image<std::uint8_t>> images;
    for (const double film_width : {0.0, 2.0}) {
        images.push_back(albedo(frame, {256, 256}, {.film_width = film_width}, 1));
    }
    return images;
}

std::size_t encoded_size(const Image<std::uint8_t>& image,
                         PngFilter filter,
                         Compression compression = Compression::Fast) {
    return encode_png(image.view(), {}, {.filter = filter, .compression = compression}).size();
}

// Why None is the default.
TEST(Png, FlatCellsAreSmallestWithoutFilter) {
    for (const Image<std::uint8_t>& image : flat_cells()) {
        const std::size_t none = encoded_size(image, PngFilter::None);
        for (const PngFilter filter :
             {PngFilter::Sub, PngFilter::Up, PngFilter::Average, PngFilter::Paeth}) {
            EXPECT_LT(none, encoded_size(image, filter)) << static_cast<int>(filter);
        }
    }
}

TEST(Png, MoreWorkMakesASmallerFile) {
    for (const Image<std::uint8_t>& image : flat_cells()) {
        const std::size_t fast = encoded_size(image, PngFilter::None);
        EXPECT_LT(encoded_size(image, PngFilter::None, Compression::Small), fast);
        EXPECT_LT(3 * fast, encoded_size(image, PngFilter::None, Compression::None));
    }
}

}  // namespace
}  // namespace foam::texgen
