// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/ktx2.h"

#include "tests/fuzz/fuzz_target.h"

namespace foam::fuzz {

void fuzz_ktx2(std::string_view input) {
    const auto texture =
        unless_rejected<InputError>([&] { return texgen::decode_ktx2(bytes_of(input)); });
    if (!texture) {
        return;
    }
    texgen::GpuTexture plain = *texture;
    plain.text.clear();  // keys may occur several times in a file
    const texgen::GpuTexture again = texgen::decode_ktx2(texgen::encode_ktx2(plain));
    require(again.layers == texture->layers && again.format == texture->format,
            "a KTX2 is read as it was written");
    unless_rejected<InputError>([&] { return texgen::picture_of(*texture); });
}

}  // namespace foam::fuzz
