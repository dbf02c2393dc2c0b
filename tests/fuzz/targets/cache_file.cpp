// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/fuzz_target.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/state_codec.h"

#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace foam::fuzz {

namespace {

constexpr std::size_t kHeaderSize = 72;  // the checksum of the rest is at the end of the header
constexpr std::string_view kSimulation = "0123456789abcdef0123456789abcdef";

// Returns the bytes with a correct checksum. Without this correction, the reader would reject
// nearly every input because of its checksum.
Bytes with_checksum(std::string_view input) {
    const std::span<const std::byte> bytes = bytes_of(input);
    Bytes file(bytes.begin(), bytes.end());
    if (file.size() >= kHeaderSize) {
        const XXH64_hash_t sum = XXH3_64bits(file.data() + kHeaderSize, file.size() - kHeaderSize);
        std::memcpy(file.data() + kHeaderSize - sizeof(sum), &sum, sizeof(sum));
    }
    return file;
}

}  // namespace

void fuzz_cache_file(std::string_view input) {
    const Bytes file = with_checksum(input);
    unless_rejected<texgen::BadContent>([&] {
        const Bytes content = texgen::unpack_file(file, {"state", kSimulation});
        return texgen::unpack_state(content, {0.0, 1.0});
    });
    unless_rejected<texgen::BadContent>([&] {
        return texgen::unpack_numbers(texgen::unpack_file(file, {"scale", kSimulation}));
    });
}

}  // namespace foam::fuzz
