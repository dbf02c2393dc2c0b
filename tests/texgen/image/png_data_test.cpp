// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_data.h"

#include "tests/support/albedo_image.h"
#include "tests/support/sample_foams.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/image/numbered.h"
#include "tests/texgen/image/png_chunks.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

// 900 x 700 RGB pixels are compressed in four parts, each of which is an IDAT chunk.
TEST(PngData, TheBytesDoNotDependOnTheNumberOfThreads) {
    Image<std::uint8_t> image(900, 700, 3);
    unsigned state = 1;
    for (std::uint8_t& sample : image.samples()) {
        state = state * 1664525 + 1013904223;
        sample = static_cast<std::uint8_t>(state >> 30);
    }
    const Bytes one = encode_png(image.view());
    const auto chunks = chunks_of(one);
    EXPECT_EQ(std::ranges::count(chunks, "IDAT", &decltype(chunks)::value_type::first), 4);
    EXPECT_EQ(codes8(decode_png(one)), image);
    for (const int threads : {0, 2, 3, 7}) {
        EXPECT_EQ(encode_png(image.view(), {}, {.threads = threads}), one) << threads;
    }
}

// Without compression, the picture is one part. Its stream has the same bytes in chunks of any
// size.
TEST(PngData, APartIsDividedIntoChunks) {
    const Image<std::uint8_t> image = numbered_codes(30, 20, 3);
    const PngRows rows(image.view());
    const PngEncoding encoding{.compression = Compression::None};
    const auto stream_of = [&](std::size_t max_bytes, std::size_t chunks) {
        PngData data(rows, encoding, max_bytes);
        Bytes stream;
        const auto found = data.next_chunks();
        EXPECT_EQ(found.size(), chunks);
        for (const PngData::Chunk& chunk : found) {
            EXPECT_LE(chunk.middle.size(), max_bytes);
            for (const auto& piece : {chunk.begin, chunk.middle, chunk.end}) {
                stream.insert(stream.end(), piece.begin(), piece.end());
            }
        }
        EXPECT_TRUE(data.complete());
        return stream;
    };
    // 20 rows of 91 bytes, and 5 bytes of the header of a stored block
    const std::size_t size = 20 * 91 + 5;
    const Bytes whole = stream_of(size, 1);
    EXPECT_EQ(whole.size(), 2 + size + 4);
    EXPECT_EQ(stream_of(size - 1, 2), whole);
    EXPECT_EQ(stream_of(609, 3), whole);
    EXPECT_EQ(stream_of(100, 19), whole);
}

/// Returns two images of flat cells, drawn as in a bake: one without films and one with films.
std::vector<Image<std::uint8_t>> flat_cells() {
    const Frame frame = test::fitted_frame(test::bent_foam(100, 0.3, 1), 256, 256);
    std::vector<Image<std::uint8_t>> images;
    for (const double film_width : {0.0, 2.0}) {
        images.push_back(test::albedo_image(frame, {256, 256}, {.film_width = film_width}, 1));
    }
    return images;
}

std::size_t encoded_size(const Image<std::uint8_t>& image,
                         PngFilter filter,
                         Compression compression = Compression::Fast) {
    return encode_png(image.view(), {}, {.filter = filter, .compression = compression}).size();
}

// PngFilter::None is the default, because it gives the smallest files of flat cells.
TEST(PngData, FlatCellsAreSmallestWithoutFilter) {
    for (const Image<std::uint8_t>& image : flat_cells()) {
        const std::size_t none = encoded_size(image, PngFilter::None);
        for (const PngFilter filter :
             {PngFilter::Sub, PngFilter::Up, PngFilter::Average, PngFilter::Paeth}) {
            EXPECT_LT(none, encoded_size(image, filter)) << static_cast<int>(filter);
        }
    }
}

TEST(PngData, MoreWorkMakesASmallerFile) {
    for (const Image<std::uint8_t>& image : flat_cells()) {
        const std::size_t fast = encoded_size(image, PngFilter::None);
        EXPECT_LT(encoded_size(image, PngFilter::None, Compression::Small), fast);
        EXPECT_LT(3 * fast, encoded_size(image, PngFilter::None, Compression::None));
    }
}

}  // namespace
}  // namespace foam::texgen
