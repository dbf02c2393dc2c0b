// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/texture_file.h"

#include "tests/texgen/pictures.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam::texgen {
namespace {

TEST(TextureFile, AFormatIsFoundByItsSuffix) {
    EXPECT_EQ(find_texture_format("a/b.dds")->suffix, ".dds");
    EXPECT_EQ(find_texture_format("b.ktx2")->suffix, ".ktx2");
    EXPECT_EQ(find_texture_format("b.png"), nullptr);
}

TEST(TextureFile, OnlyASingleLayerIsAPicture) {
    Image<std::uint8_t> codes(2, 1, 1);
    codes.samples()[1] = 200;
    const Picture picture{{code_channels(codes)}, {}};
    for (const char* suffix : {".dds", ".ktx2"}) {
        const TextureFormat& format = *find_texture_format(suffix);
        const GpuEncoding exact{.blocks = BlockCompression::None};
        EXPECT_EQ(codes8(decode_picture(format, encode_picture(format, picture, exact))), codes);
        GpuTexture array = texture_of(picture, exact);
        array.is_array = true;
        array.layers.push_back(array.layers.front());
        EXPECT_THROW(decode_picture(format, format.encode(array)), InputError);
    }
}

}  // namespace
}  // namespace foam::texgen
