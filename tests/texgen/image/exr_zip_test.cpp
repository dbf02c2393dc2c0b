// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/image/numbered.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/exr.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>

namespace foam::texgen {
namespace {

Bytes encoded(const Image<std::uint32_t>& ids, const ExrEncoding& encoding) {
    const ExrChannel channel{"Y", SampleType::Uint32, ids.view()};
    return encode_exr(std::span(&channel, 1), {}, encoding);
}

// Returns numbers that cannot be compressed.
Image<std::uint32_t> noise(int width, int height) {
    std::mt19937 random(1);
    Image<std::uint32_t> ids(width, height, 1);
    for (std::uint32_t& id : ids.samples()) {
        id = static_cast<std::uint32_t>(random());
    }
    return ids;
}

// OpenEXR decodes each image. Heights are less than, equal to and more than a chunk of 16 rows.
TEST(ExrZip, OpenExrReadsEveryHeightLevelAndNumberOfThreads) {
    for (const auto compression : {ExrCompression::Zip, ExrCompression::Zips}) {
        for (const int height : {1, 15, 16, 17, 33}) {
            Image<std::uint32_t> ids(7, height, 1);
            for (std::size_t k = 0; k < ids.samples().size(); ++k) {
                ids.samples()[k] = static_cast<std::uint32_t>(k / 5);
            }
            for (int level = 1; level <= 9; ++level) {
                const Bytes file =
                    encoded(ids, {.compression = compression, .zip_level = level, .threads = 3});
                EXPECT_EQ(integers(decode_exr(file).groups[0]), ids) << height << ' ' << level;
            }
        }
    }
}

// A chunk that would become larger is stored as it is, after eight bytes and an offset of eight.
TEST(ExrZip, NoiseIsStored) {
    constexpr int kRows = 40;
    const Image<std::uint32_t> ids = noise(32, kRows);
    const Bytes file = encoded(ids, {});
    const Bytes empty =
        encoded(Image<std::uint32_t>(32, 1, 1), {.compression = ExrCompression::None});
    const std::size_t header = empty.size() - 32 * 4 - 16;
    EXPECT_EQ(file.size(), header + 32 * kRows * 4 + 3 * 16);
    EXPECT_EQ(integers(decode_exr(file).groups[0]), ids);
}

// Names of more than 31 characters need a flag in the header.
TEST(ExrZip, OpenExrReadsLongNames) {
    const Image<std::uint32_t> ids = noise(3, 3);
    const ExrChannel channel{std::string(40, 'a'), SampleType::Uint32, ids.view()};
    const Picture back = decode_exr(encode_exr(std::span(&channel, 1), {}, {}));
    EXPECT_EQ(back.groups[0].names.front(), std::string(40, 'a'));
    EXPECT_EQ(integers(back.groups[0]), ids);
}

}  // namespace
}  // namespace foam::texgen
