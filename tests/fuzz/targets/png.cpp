// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png.h"

#include "tests/fuzz/fuzz_target.h"

namespace foam::fuzz {

namespace {

constexpr int kLargestEncoded = 1 << 16;  // pixels; larger images would take most of the time

}  // namespace

void fuzz_png(std::string_view input) {
    const auto picture =
        unless_rejected<InputError>([&] { return texgen::decode_png(bytes_of(input)); });
    if (!picture || picture->width() > kLargestEncoded / picture->height()) {
        return;
    }
    const texgen::Picture plain{picture->groups, {}};
    const texgen::Picture again = texgen::decode_png(texgen::encode_png(plain));
    require(again.groups.front().samples == picture->groups.front().samples,
            "a PNG is read as it was written");
}

}  // namespace foam::fuzz
