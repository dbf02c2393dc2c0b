// SPDX-License-Identifier: Apache-2.0

#include "tests/support/limited_address_space.h"
#include "tests/support/sample_foams.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/image/numbered.h"
#include "tests/texgen/image/png_chunks.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

using Text = std::vector<std::pair<std::string, std::string>>;

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
            .compression = static_cast<Compression>(*rc::gen::inRange(0, 3))};
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

void put(std::span<std::byte> target, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) {
        target[i] = static_cast<std::byte>(number >> (24 - 8 * i));
    }
}

RC_GTEST_PROP(PngDecode, PixelsAndTextsRoundTrip, ()) {
    const auto image = any_image<std::uint8_t>();
    const ImageMetadata metadata{.color = *rc::gen::arbitrary<bool>(), .text = {{"Seed", "1"}}};
    const Picture back = decode_png(encode_png(image.view(), metadata, any_encoding()));
    RC_ASSERT(codes8(back) == image);
    RC_ASSERT(back.metadata.color == metadata.color);
    RC_ASSERT(back.metadata.text == metadata.text);
}

RC_GTEST_PROP(PngDecode, SixteenBitPixelsRoundTrip, ()) {
    const auto image = any_image<std::uint16_t>();
    const Bytes stream = encode_png(image.view(), {}, any_encoding());
    RC_ASSERT(codes16(decode_png(stream)) == image);
}

TEST(PngDecode, SamplesAreReadInTheDepthOfTheFile) {
    const Picture bytes = decode_png(encode_png(Image<std::uint8_t>(3, 1, 2).view()));
    EXPECT_EQ(bytes.groups.front().type, SampleType::Uint8);
    EXPECT_EQ(bytes.groups.front().names, (std::vector<std::string>{"Y", "A"}));
    const Picture words = decode_png(encode_png(Image<std::uint16_t>(3, 1, 3).view()));
    EXPECT_EQ(words.groups.front().type, SampleType::Uint16);
}

// A text whose chunk claims a length of two gibibytes is rejected before memory for it is
// allocated. The chunk is inserted after the signature and the chunk IHDR, which have 33 bytes. The
// limit of the address space makes the allocation fail, which libpng would report as "out of
// memory".
TEST(PngDecode, AChunkLongerThanTheFileIsNotAllocated) {
    if (foam::test::kMayHaveSanitizers) {
        GTEST_SKIP() << "sanitizers need a large address space";
    }
    Bytes stream = encode_png(Image<std::uint8_t>(3, 1, 3).view());
    Bytes text(20);
    put(std::span(text), 0x7fffff00U);
    std::memcpy(&text[4], "tEXt", 4);
    stream.insert(stream.begin() + 33, text.begin(), text.end());
    const foam::test::LimitedAddressSpace limited(rlim_t{1} << 30U);
    std::string message;
    try {
        decode_png(stream);
    } catch (const InputError& error) {
        message = error.what();
    }
    EXPECT_EQ(message, "malformed PNG: unexpected end of the data");
}

TEST(PngDecode, BytesAfterTheLastChunkAreIgnored) {
    const Image<std::uint8_t> image(3, 1, 3);
    Bytes stream = encode_png(image.view());
    stream.insert(stream.end(), 50, std::byte{0xff});
    EXPECT_EQ(decode_png(stream).groups.size(), 1U);
}

// At the place of the length of the first chunk, a JPEG has other bytes.
TEST(PngDecode, AnotherKindOfFileIsNamed) {
    Bytes stream(40, std::byte{0x49});
    try {
        decode_png(stream);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "malformed PNG: Not a PNG file");
    }
}

// libpng skips a chunk of an unknown kind, even before the header: length 0, type, check sum.
TEST(PngDecode, TheDepthIsThatOfTheHeaderWhereverItIs) {
    Bytes stream = encode_png(Image<std::uint16_t>(3, 1, 3).view());
    Bytes unknown(12);
    std::memcpy(&unknown[4], "abCd", 4);
    put(std::span(unknown).subspan(8), crc_of(std::span(unknown).subspan(4, 4)));
    stream.insert(stream.begin() + 8, unknown.begin(), unknown.end());
    EXPECT_EQ(decode_png(stream).groups.front().type, SampleType::Uint16);
}

TEST(PngDecode, EveryTruncationIsAnInputError) {
    const Bytes stream =
        encode_png(numbered_codes(4, 4, 3).view(), {.color = true, .text = {{"a", "b"}}});
    for (std::size_t size = 0; size < stream.size(); ++size) {
        EXPECT_THROW(decode_png(std::span(stream).first(size)), InputError) << size;
    }
}

TEST(PngDecode, ADamagedPixelStreamIsAnInputError) {
    Bytes stream = encode_png(numbered_codes(4, 4, 3).view());
    stream[8 + 25 + 8 + 10] ^= std::byte{0xff};  // in the IDAT chunk, after signature and IHDR
    EXPECT_THROW(decode_png(stream), InputError);
}

// A file of a few bytes claims 900000 x 900000 pixels. It is rejected before memory is allocated.
TEST(PngDecode, AHeaderOfAHugeImageIsAnInputError) {
    Bytes stream = encode_png(numbered_codes(1, 1, 3).view());
    const std::span bytes(stream);
    put(bytes.subspan(16, 4), 900'000);  // the header's content starts after 8 + 8 bytes
    put(bytes.subspan(20, 4), 900'000);
    put(bytes.subspan(29, 4), crc_of(bytes.subspan(12, 17)));
    EXPECT_THROW(decode_png(stream), InputError);
}

TEST(PngDecode, FilesAreReadAsWritten) {
    const TemporaryFolder folder;
    const Image<std::uint8_t> image = numbered_codes(5, 7, 3);
    write_png(folder.path() / "a.png", image.view(), {.color = true, .text = {{"Seed", "9"}}});
    const Picture back = read_picture(folder.path() / "a.png");
    EXPECT_EQ(codes8(back), image);
    EXPECT_EQ(back.metadata.text, (Text{{"Seed", "9"}}));
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.png"});
}

TEST(PngDecode, AMalformedFileIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.png";
    write_file(path, Bytes(20));
    try {
        read_picture(path);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot read '" + path.string() + "': malformed PNG: Not a PNG file");
    }
}

// Returns a chunk of a PNG.
Bytes chunk_of(const std::string& type, const Bytes& content) {
    Bytes chunk(8 + content.size() + 4);
    const std::span<std::byte> bytes(chunk);
    put(bytes, static_cast<std::uint32_t>(content.size()));
    std::memcpy(bytes.subspan(4).data(), type.data(), 4);
    std::ranges::copy(content, bytes.subspan(8).begin());
    put(bytes.last(4), crc_of(bytes.subspan(4, 4 + content.size())));
    return chunk;
}

// Returns a PNG of gray samples of one bit, whose pixels would need `size` bytes of data.
Bytes large_png(std::uint32_t side, std::size_t size) {
    Bytes header(13);
    put(header, side);
    put(std::span(header).subspan(4), side);
    header[8] = std::byte{1};  // bits per sample
    Bytes stream;
    for (const int byte : {137, 80, 78, 71, 13, 10, 26, 10}) {
        stream.push_back(static_cast<std::byte>(byte));
    }
    for (const Bytes& chunk : {chunk_of("IHDR", header), chunk_of("IDAT", Bytes(size))}) {
        stream.insert(stream.end(), chunk.begin(), chunk.end());
    }
    return stream;
}

// Zeros of one bit can be compressed to 1.2 MB, but libpng expands them to 10 GB.
TEST(PngDecode, AnImageOfTooManyPixelsIsAnInputError) {
    try {
        decode_png(large_png(100'000, 1'300'000));
        FAIL() << "the image was accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "an image of 100000 x 100000 pixels is too large: at most 1073741824 pixels are "
                  "supported");
    }
}

}  // namespace
}  // namespace foam::texgen
