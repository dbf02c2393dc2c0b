// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_chunk.h"

#include "texgen/image/byte_order.h"

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr std::size_t kWord = 4;  // bytes of each field of a chunk: length, type, checksum

}  // namespace

std::optional<std::span<const std::byte>> after_png_signature(std::span<const std::byte> png) {
    const std::size_t size = kPngSignature.size();
    if (png.size() < size ||
        !std::ranges::equal(png.first(size), std::as_bytes(std::span(kPngSignature)))) {
        return std::nullopt;
    }
    return png.subspan(size);
}

std::optional<PngChunk> take_png_chunk(std::span<const std::byte>& rest) {
    if (rest.size() < 3 * kWord || rest.size() - 3 * kWord < from_big_endian(rest)) {
        return std::nullopt;
    }
    const std::size_t size = from_big_endian(rest);
    const auto* type = reinterpret_cast<const char*>(rest.data() + kWord);
    const PngChunk chunk{{type, kWord}, rest.subspan(2 * kWord, size)};
    rest = rest.subspan(3 * kWord + size);
    return chunk;
}

}  // namespace foam::texgen
