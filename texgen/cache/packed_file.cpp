// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/packed_file.h"

#include "texgen/cache/byte_stream.h"

#include <fmt/core.h>
#include <libdeflate.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <string>

namespace foam::texgen {

namespace {

constexpr std::string_view kMagic = "foamtex";
constexpr int kLevel = 6;  // compression level of libdeflate, from 0 (none) to 12
// The largest compression ratio of deflate. A header that claims a larger ratio is rejected before
// memory is allocated for the content.
constexpr std::size_t kMaxDeflateRatio = 1032;

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
    void operator()(libdeflate_decompressor* decompressor) const {
        libdeflate_free_decompressor(decompressor);
    }
};

/// The header of a packed file, in the layout of the file.
struct Header {
    std::array<char, 8> magic{};
    std::array<char, 8> kind{};
    std::uint32_t version = kPackedVersion;
    std::uint32_t unused = 0;
    std::array<char, 32> simulation_hash{};
    std::uint64_t size = 0;  // size of the uncompressed content, in bytes
    std::uint64_t sum = 0;   // XXH3 of the compressed bytes, which follow the header
};
static_assert(sizeof(Header) == 72, "a header has no gaps");

// Returns the characters of a text, cut to the given size or padded with zero bytes.
template <std::size_t size>
std::array<char, size> letters(std::string_view text) {
    std::array<char, size> array{};
    std::copy_n(text.begin(), std::min(text.size(), size), array.begin());
    return array;
}

Bytes compressed(std::span<const std::byte> content) {
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kLevel));
    if (compressor == nullptr) {
        throw std::bad_alloc();
    }
    Bytes packed(libdeflate_deflate_compress_bound(compressor.get(), content.size()));
    packed.resize(libdeflate_deflate_compress(
        compressor.get(), content.data(), content.size(), packed.data(), packed.size()));
    return packed;
}

Bytes decompressed(std::span<const std::byte> packed, std::uint64_t size) {
    if (size > kMaxStateContent) {
        throw BadContent(fmt::format("its content is too large: {} MiB, at most {} MiB",
                                     size / kMebibyte,
                                     kMaxStateContent / kMebibyte));
    }
    if (size / kMaxDeflateRatio > packed.size()) {
        throw BadContent("the file is damaged: its header gives an impossible content size");
    }
    const std::unique_ptr<libdeflate_decompressor, FreeCompressor> decompressor(
        libdeflate_alloc_decompressor());
    if (decompressor == nullptr) {
        throw std::bad_alloc();
    }
    Bytes content(size);
    const libdeflate_result result = libdeflate_deflate_decompress(
        decompressor.get(), packed.data(), packed.size(), content.data(), size, nullptr);
    if (result != LIBDEFLATE_SUCCESS) {
        throw BadContent("the compressed data is damaged");
    }
    return content;
}

void check(const Header& header, const PackedLabel& label, std::span<const std::byte> packed) {
    if (header.magic != letters<8>(kMagic) || header.kind != letters<8>(label.kind)) {
        throw BadContent(fmt::format("not a foamtex file of kind '{}'", label.kind));
    }
    if (header.version != kPackedVersion) {
        throw BadContent(fmt::format(
            "file version {} is not supported; must be {}", header.version, kPackedVersion));
    }
    if (header.sum != XXH3_64bits(packed.data(), packed.size())) {
        throw BadContent("the file is damaged: its checksum does not match");
    }
    if (header.simulation_hash != letters<32>(label.simulation_hash)) {
        throw BadContent("the file belongs to a different simulation than its cache");
    }
}

}  // namespace

void write_packed(const std::filesystem::path& path,
                  const PackedLabel& label,
                  std::span<const std::byte> content) {
    const Bytes packed = compressed(content);
    const Header header{.magic = letters<8>(kMagic),
                        .kind = letters<8>(label.kind),
                        .simulation_hash = letters<32>(label.simulation_hash),
                        .size = content.size(),
                        .sum = XXH3_64bits(packed.data(), packed.size())};
    Bytes file(sizeof(Header) + packed.size());
    std::memcpy(file.data(), &header, sizeof(Header));
    std::ranges::copy(packed, file.begin() + sizeof(Header));
    write_file(path, file);
}

Bytes unpack_file(std::span<const std::byte> file, const PackedLabel& label) {
    if (file.size() < sizeof(Header)) {
        throw BadContent(fmt::format("not a foamtex file of kind '{}'", label.kind));
    }
    Header header;
    std::memcpy(&header, file.data(), sizeof(Header));
    const auto packed = file.subspan(sizeof(Header));
    check(header, label, packed);
    return decompressed(packed, header.size);
}

Bytes read_packed(const std::filesystem::path& path, const PackedLabel& label) {
    const Bytes file = read_file(path, kStateInput);
    try {
        return unpack_file(file, label);
    } catch (const BadContent& error) {
        fail_to_read(path, error.what());
    }
}

}  // namespace foam::texgen
