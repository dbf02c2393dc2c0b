// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_chunk.h"

#include "core/files/file_io.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(PngChunk, ChunksAreTakenOneByOne) {
    const Bytes png = encode_png(Image<std::uint8_t>(3, 2, 1).view());
    auto rest = after_png_signature(png);
    ASSERT_TRUE(rest.has_value());
    std::vector<std::string> types;
    while (const auto chunk = take_png_chunk(*rest)) {
        types.emplace_back(chunk->type);
        if (chunk->type == "IHDR") {
            EXPECT_EQ(chunk->content.size(), 13U);
        }
    }
    EXPECT_TRUE(rest->empty());
    EXPECT_EQ(types.front(), "IHDR");
    EXPECT_EQ(types.back(), "IEND");
}

TEST(PngChunk, AnIncompleteChunkIsNotTaken) {
    const Bytes png = encode_png(Image<std::uint8_t>(3, 2, 1).view());
    const auto content = *after_png_signature(png);
    constexpr std::size_t kHeader = 12 + 13;  // of the chunk IHDR
    for (std::size_t size = 0; size < kHeader; ++size) {
        auto rest = content.first(size);
        EXPECT_FALSE(take_png_chunk(rest).has_value()) << size;
        EXPECT_EQ(rest.size(), size);
    }
    auto rest = content.first(kHeader);
    EXPECT_TRUE(take_png_chunk(rest).has_value());
}

TEST(PngChunk, OtherFilesHaveNoSignature) {
    EXPECT_FALSE(after_png_signature(std::as_bytes(std::span("JPEG JFIF"))).has_value());
    EXPECT_FALSE(after_png_signature({}).has_value());
}

}  // namespace
}  // namespace foam::texgen
