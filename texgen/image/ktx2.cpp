// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/ktx2.h"

#include "core/files/content_text.h"
#include "texgen/image/byte_reader.h"
#include "texgen/image/data_format.h"
#include "texgen/image/texture_limits.h"

#include <fmt/core.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>

// The file format is KTX 2.0 (KTX File Format Specification). A header and an index of the mip
// levels come first. A data format descriptor (Khronos Data Format Specification 1.3) and key/value
// data follow. The levels are last, the smallest one first. A level holds the images of all layers.

namespace foam::texgen {

namespace {

constexpr std::array<std::uint8_t, 12> kIdentifier = {
    0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kKtx2HeaderBytes = 80;  // everything before the index of the levels
constexpr std::size_t kLevelEntryBytes = 24;  // an entry of the index of levels
constexpr std::uint32_t kZstandard = 2;       // scheme of supercompression
constexpr int kZstandardLevel = 5;
constexpr std::size_t kMaxLevelBytes = std::size_t{1} << 32U;  // all layers, uncompressed
// The largest compression ratio of Zstandard: a block of 4 bytes can stand for 128 KiB of equal
// bytes. Larger ratios are rejected, so that a small file cannot claim much memory.
constexpr std::size_t kMaxRatio = 32768;
constexpr std::string_view kAnimation = "KTXanimData";
constexpr std::size_t kAnimationBytes = 12;  // three numbers, which animation_value explains

void check_ktx2(bool holds, const char* reason) {
    if (!holds) {
        throw InputError(fmt::format("malformed KTX2: {}", reason));
    }
}

// Appends bytes of 0 until the size is a multiple of `unit`.
void pad(Bytes& bytes, std::size_t unit) {
    bytes.resize((bytes.size() + unit - 1) / unit * unit);
}

// Returns the value of KTXanimData: frame duration, time units per second, loops (0: endless).
std::string animation_value(const TextureAnimation& animation) {
    Bytes bytes;
    append_number(bytes, static_cast<std::uint32_t>(animation.rate.seconds));
    append_number(bytes, static_cast<std::uint32_t>(animation.rate.frames));
    append_number(bytes, animation.repeats ? 0U : 1U);
    return std::string(as_text(bytes));
}

// Returns the keys and values of a file, sorted as the specification requires. Values that are
// texts end with a byte of 0. KTXswizzle marks an opaque texture whose format has four channels.
Bytes key_value_data(const GpuTexture& texture) {
    std::map<std::string, std::string, std::less<>> values(texture.text.begin(),
                                                           texture.text.end());
    values["KTXorientation"] = "rd";  // x to the right, y down
    values["KTXwriter"] = "foamtex " FOAMTEX_VERSION;
    if (texture.opaque && facts_of(texture.format).channels == 4) {
        values["KTXswizzle"] = "rgb1";
    }
    for (auto& [key, value] : values) {
        value.push_back('\0');
    }
    if (texture.is_array && texture.animation) {
        values.emplace(kAnimation, animation_value(*texture.animation));
    }
    Bytes bytes;
    for (const auto& [key, value] : values) {
        append_number(bytes, static_cast<std::uint32_t>(key.size() + 1 + value.size()));
        const std::string entry = fmt::format("{}{}{}", key, '\0', value);
        const auto characters = std::as_bytes(std::span(entry));
        bytes.insert(bytes.end(), characters.begin(), characters.end());
        pad(bytes, 4);
    }
    return bytes;
}

// Returns the images of all layers at one mip level.
Bytes level_of(const GpuTexture& texture, int level) {
    Bytes bytes;
    for (const std::vector<Bytes>& layer : texture.layers) {
        const Bytes& image = layer[static_cast<std::size_t>(level)];
        bytes.insert(bytes.end(), image.begin(), image.end());
    }
    return bytes;
}

Bytes compressed(const Bytes& bytes) {
    Bytes packed(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstandardLevel);
    if (ZSTD_isError(size) != 0) {
        throw OutputError(fmt::format("Zstandard failed: {}", ZSTD_getErrorName(size)));
    }
    packed.resize(size);
    return packed;
}

Bytes decompressed(std::span<const std::byte> packed, std::size_t size) {
    Bytes bytes(size);
    const std::size_t found =
        ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    check_ktx2(ZSTD_isError(found) == 0 && found == size, "a mip level cannot be decompressed");
    return bytes;
}

// The position and the sizes of a mip level in a file.
struct LevelEntry {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t uncompressed = 0;
};

void append_offset_and_size(Bytes& bytes, std::size_t offset, std::size_t size) {
    append_number(bytes, static_cast<std::uint32_t>(offset));
    append_number(bytes, static_cast<std::uint32_t>(size));
}

Bytes header_of(const GpuTexture& texture, std::size_t descriptor_bytes, std::size_t value_bytes) {
    const PixelFormatFacts& facts = facts_of(texture.format);
    Bytes bytes;
    for (const std::uint8_t byte : kIdentifier) {
        bytes.push_back(static_cast<std::byte>(byte));
    }
    const auto levels = static_cast<std::uint32_t>(texture.levels());
    for (const std::uint32_t number :
         {facts.vulkan,
          facts.is_compressed || facts.bits == 8 ? 1U : 2U,
          static_cast<std::uint32_t>(texture.width),
          static_cast<std::uint32_t>(texture.height),
          0U,  // depth
          texture.is_array ? static_cast<std::uint32_t>(texture.layers.size()) : 0U,
          1U,  // faces
          levels,
          kZstandard}) {
        append_number(bytes, number);
    }
    const std::size_t descriptor = kKtx2HeaderBytes + levels * kLevelEntryBytes;
    append_offset_and_size(bytes, descriptor, descriptor_bytes);
    append_offset_and_size(bytes, descriptor + descriptor_bytes, value_bytes);
    append_number(bytes, std::uint64_t{0});  // there are no global data of the supercompression
    append_number(bytes, std::uint64_t{0});
    return bytes;
}

// Reads the value of KTXanimData. Any number of loops except 1 is read as a repetition.
TextureAnimation animation_in(std::span<const std::byte> value) {
    check_ktx2(value.size() == kAnimationBytes, "KTXanimData has another size than 12 bytes");
    ByteReader reader(value);
    const std::uint32_t duration = reader.number();
    const std::uint32_t timescale = reader.number();
    constexpr std::uint32_t kMax = std::numeric_limits<int>::max();
    check_ktx2(duration > 0 && timescale > 0 && duration <= kMax && timescale <= kMax,
               "KTXanimData gives no frame rate");
    return {.rate = {static_cast<int>(timescale), static_cast<int>(duration)},
            .repeats = reader.number() != 1};
}

void read_values(std::span<const std::byte> data, GpuTexture& texture) {
    ByteReader reader(data);
    texture.opaque = false;
    while (reader.remaining() >= 4) {
        const std::uint32_t size = reader.number();
        const auto entry = reader.take(size);
        reader.take(std::min<std::size_t>((4 - size % 4) % 4, reader.remaining()));
        const auto end = std::ranges::find(entry, std::byte{0});
        check_ktx2(end != entry.end(), "a key has no end");
        const auto key_size = static_cast<std::size_t>(end - entry.begin());
        const std::string key(as_text(entry.first(key_size)));
        const auto value_bytes = entry.subspan(key_size + 1);
        if (key == kAnimation) {
            texture.animation = animation_in(value_bytes);
            continue;
        }
        std::string value(as_text(value_bytes));
        if (value.ends_with('\0')) {
            value.pop_back();
        }
        texture.opaque = texture.opaque || (key == "KTXswizzle" && value == "rgb1");
        if (!key.starts_with("KTX")) {
            texture.text.emplace_back(key, value);
        }
    }
}

std::span<const std::byte> part_of(std::span<const std::byte> content,
                                   std::uint64_t offset,
                                   std::uint64_t size) {
    check_ktx2(offset <= content.size() && size <= content.size() - offset,
               "a part is outside of the file");
    return content.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

// Reads the images of all layers at one mip level. Needs memory for two copies of these images.
void read_level(std::span<const std::byte> packed,
                int level,
                std::uint64_t uncompressed,
                GpuTexture& texture) {
    const std::size_t image = image_bytes(
        texture.format, level_extent(texture.width, level), level_extent(texture.height, level));
    check_ktx2(uncompressed == image * texture.layers.size(), "a mip level has the wrong size");
    check_supported("KTX2", uncompressed <= kMaxLevelBytes, "has a mip level of more than 4 GiB");
    const unsigned long long claimed = ZSTD_getFrameContentSize(packed.data(), packed.size());
    check_ktx2(claimed == uncompressed && uncompressed / kMaxRatio <= packed.size(),
               "the compressed data of a mip level does not fit the size in the index of levels");
    require_texture_memory(2 * uncompressed, texture.width, texture.height);
    const Bytes bytes = decompressed(packed, static_cast<std::size_t>(uncompressed));
    for (std::size_t k = 0; k < texture.layers.size(); ++k) {
        const auto part = std::span(bytes).subspan(k * image, image);
        texture.layers[k][static_cast<std::size_t>(level)].assign(part.begin(), part.end());
    }
}

}  // namespace

Bytes encode_ktx2(const GpuTexture& texture) {
    const Bytes descriptor = data_format_descriptor(texture.format);
    const Bytes values = key_value_data(texture);
    Bytes file = header_of(texture, descriptor.size(), values.size());
    const auto levels = static_cast<std::size_t>(texture.levels());
    const std::size_t index = file.size();
    std::size_t offset = index + levels * kLevelEntryBytes + descriptor.size() + values.size();
    std::vector<Bytes> packed(levels);
    std::vector<LevelEntry> entries(levels);
    for (std::size_t level = levels; level-- > 0;) {
        const Bytes plain = level_of(texture, static_cast<int>(level));
        packed[level] = compressed(plain);
        entries[level] = {offset, packed[level].size(), plain.size()};
        offset += packed[level].size();
    }
    for (const LevelEntry& entry : entries) {
        append_number(file, entry.offset);
        append_number(file, entry.bytes);
        append_number(file, entry.uncompressed);
    }
    file.insert(file.end(), descriptor.begin(), descriptor.end());
    file.insert(file.end(), values.begin(), values.end());
    for (std::size_t level = levels; level-- > 0;) {
        file.insert(file.end(), packed[level].begin(), packed[level].end());
    }
    return file;
}

GpuTexture decode_ktx2(std::span<const std::byte> content) {
    ByteReader reader(content);
    const auto identifier = reader.take(kIdentifier.size());
    check_ktx2(std::ranges::equal(identifier, std::as_bytes(std::span(kIdentifier))),
               "the file does not begin with the identifier");
    const std::uint32_t vulkan = reader.number();
    const std::optional<PixelFormat> format = find_vulkan_format(vulkan);
    if (!format) {
        throw InputError(
            fmt::format("the KTX2 has the pixel format {}, which foamtex does not read", vulkan));
    }
    reader.number();  // size of the data type
    const std::uint32_t width = reader.number();
    const std::uint32_t height = reader.number();
    check_supported("KTX2", reader.number() == 0, "is a volume");
    const std::uint32_t layers = reader.number();
    check_supported("KTX2", reader.number() == 1, "is a cube");
    const std::uint32_t levels = reader.number();
    check_texture_size("KTX2", width, height, levels, std::max(layers, 1U));
    check_supported("KTX2", reader.number() == kZstandard, "is not compressed with Zstandard");
    const std::uint32_t descriptor_offset = reader.number();
    const std::uint32_t descriptor_bytes = reader.number();
    check_straight_alpha(part_of(content, descriptor_offset, descriptor_bytes));
    const std::uint32_t values_offset = reader.number();
    const std::uint32_t values_bytes = reader.number();
    reader.take(16);  // offset and size of the global data
    GpuTexture texture{
        .format = *format,
        .width = static_cast<int>(width),
        .height = static_cast<int>(height),
        .is_array = layers > 0,
        .layers = std::vector<std::vector<Bytes>>(std::max(layers, 1U), std::vector<Bytes>(levels)),
        .text = {}};
    read_values(part_of(content, values_offset, values_bytes), texture);
    for (int level = 0; level < static_cast<int>(levels); ++level) {
        const auto offset = reader.number<std::uint64_t>();
        const auto bytes = reader.number<std::uint64_t>();
        const auto uncompressed = reader.number<std::uint64_t>();
        read_level(part_of(content, offset, bytes), level, uncompressed, texture);
    }
    return texture;
}

}  // namespace foam::texgen
