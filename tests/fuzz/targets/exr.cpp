// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr.h"

#include "tests/fuzz/fuzz_target.h"

#include <stdexcept>

namespace foam::fuzz {

namespace {

constexpr int kLargestEncoded = 1 << 14;  // pixels; larger images would take most of the time

void check_writing(const texgen::Picture& picture) {
    if (picture.width() > kLargestEncoded / picture.height()) {
        return;
    }
    // Fuzzed pictures often have numbers or texts that cannot be written.
    const auto written = unless_rejected<std::invalid_argument, OutputError>(
        [&] { return texgen::encode_exr(picture); });
    if (!written) {
        return;
    }
    const texgen::Picture again = texgen::decode_exr(*written);
    require(again.groups.size() == picture.groups.size(), "an EXR keeps its channels");
    for (std::size_t k = 0; k < again.groups.size(); ++k) {
        require(again.groups[k].samples == picture.groups[k].samples,
                "an EXR is read as it was written");
    }
}

}  // namespace

void fuzz_exr(std::string_view input) {
    for (const int level : {0, 1}) {
        const auto picture =
            unless_rejected<InputError>([&] { return texgen::decode_exr(bytes_of(input), level); });
        if (picture) {
            check_writing(*picture);
        }
    }
}

}  // namespace foam::fuzz
