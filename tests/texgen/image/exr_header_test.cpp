// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr_header.h"

#include "tests/support/test_files.h"
#include "tests/texgen/image/numbered.h"
#include "texgen/image/exr.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace foam::texgen {
namespace {

Bytes encoded(const ExrEncoding& encoding = {}) {
    const Image<float> image = numbered_floats(8, 8, 1);
    const ExrChannel channel{"Y", SampleType::Half, image.view()};
    return encode_exr(std::span(&channel, 1), {}, encoding);
}

// Returns the position of the value of an attribute. Its size is in the 4 bytes before.
std::size_t value_of(const Bytes& file, const std::string& name, const std::string& type) {
    const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
    const std::string begin = name + '\0' + type + '\0';
    return text.find(begin) + begin.size() + 4;
}

template <class Number, std::size_t count>
void put(Bytes& file, std::size_t at, const std::array<Number, count>& numbers) {
    std::memcpy(&file[at], numbers.data(), sizeof numbers);
}

std::string fault_of(const Bytes& file) {
    try {
        check_exr_header(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// Changes the size of the image to width x height pixels.
std::string fault_of_size(Bytes file, std::int32_t width, std::int32_t height) {
    put(file,
        value_of(file, "dataWindow", "box2i"),
        std::array<std::int32_t, 4>{0, 0, width - 1, height - 1});
    return fault_of(file);
}

TEST(ExrHeader, AcceptsWhatTheEncoderWrites) {
    for (int kind = 0; kind < 5; ++kind) {
        const auto compression = static_cast<ExrCompression>(kind);
        EXPECT_EQ(fault_of(encoded({.compression = compression})), "");
        EXPECT_EQ(fault_of(encoded({.compression = compression, .mip_levels = true})), "");
    }
}

TEST(ExrHeader, RejectsImagesThatAreTooLargeForTheFile) {
    const Bytes rows = encoded();
    EXPECT_EQ(fault_of_size(rows, 1'000'001, 1),
              "an image of 1000001 x 1 pixels is too large: at most 1000000 pixels per side and "
              "1073741824 pixels are supported");
    EXPECT_NE(fault_of_size(rows, 100'000, 100'000), "");
    EXPECT_NE(fault_of_size(rows, 9'999'999, 9'999'999), "");
    EXPECT_EQ(fault_of_size(rows, 10'000, 10'000),
              "the data is too short for an image of this size");
    // The pixels could be compressed to this size, but not the positions of the blocks of rows.
    EXPECT_EQ(fault_of_size(rows, 1, 200'000), "the data is too short for an image of this size");
    EXPECT_NE(fault_of_size(encoded({.mip_levels = true}), 200'000, 1), "");
}

// A tile of 60000 x 60000 pixels in an image of 8 x 8 pixels would need 13 GiB.
TEST(ExrHeader, RejectsHugeTiles) {
    Bytes file = encoded({.mip_levels = true});
    put(file, value_of(file, "tiles", "tiledesc"), std::array<std::uint32_t, 2>{60'000, 60'000});
    EXPECT_EQ(fault_of(file), "the blocks of rows or the tiles are too large");
}

// OpenEXR checks the size of tiles only if the flag of tiled images is set. The flag is in the
// sixth byte of the file.
TEST(ExrHeader, RejectsTilesWithoutPixels) {
    for (const auto& size : {std::array<std::uint32_t, 2>{0, 8}, {8, 0}, {0, 0}}) {
        Bytes file = encoded({.mip_levels = true});
        put(file, value_of(file, "tiles", "tiledesc"), size);
        file[5] = std::byte{0};
        EXPECT_EQ(fault_of(file), "a tile or a block of rows has no pixels");
    }
}

TEST(ExrHeader, RejectsAttributesOfTheWrongSize) {
    Bytes file = encoded();
    put(file, value_of(file, "displayWindow", "box2i") - 4, std::array<std::uint32_t, 1>{1});
    EXPECT_EQ(fault_of(file), "an attribute of type box2i must have 16 bytes, not 1");
    Bytes long_list = encoded();
    put(long_list,
        value_of(long_list, "channels", "chlist") - 4,
        std::array<std::uint32_t, 1>{0x7fffffff});
    EXPECT_EQ(fault_of(long_list), "unexpected end of the header");
}

// Found by random changes: OpenEXR allocated 2 GB for a text of this length.
TEST(ExrHeader, RejectsAFileWithALongAttribute) {
    const Bytes file =
        read_file(foam::test::data_folder() / "damaged/long_attribute.exr", kImageInput);
    EXPECT_EQ(fault_of(file), "an attribute of type box2i must have 16 bytes, not 1");
}

TEST(ExrHeader, RejectsEveryTruncationOfAHeader) {
    const Bytes file = encoded();
    const std::size_t end = value_of(file, "screenWindowWidth", "float") + 4;
    for (std::size_t size = 0; size < end; ++size) {
        EXPECT_THROW(check_exr_header(std::span(file).first(size)), InputError) << size;
    }
}

}  // namespace
}  // namespace foam::texgen
