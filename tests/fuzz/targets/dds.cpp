// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/dds.h"

#include "tests/fuzz/fuzz_target.h"

namespace foam::fuzz {

void fuzz_dds(std::string_view input) {
    const auto texture =
        unless_rejected<InputError>([&] { return texgen::decode_dds(bytes_of(input)); });
    if (!texture) {
        return;
    }
    const texgen::GpuTexture again = texgen::decode_dds(texgen::encode_dds(*texture));
    require(again.layers == texture->layers && again.format == texture->format,
            "a DDS is read as it was written");
    unless_rejected<InputError>([&] { return texgen::picture_of(*texture); });
}

}  // namespace foam::fuzz
