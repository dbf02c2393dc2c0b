// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/data_format.h"

#include "texgen/image/byte_reader.h"
#include "texgen/image/texture_limits.h"

#include <cstdint>

namespace foam::texgen {

namespace {

// Numbers of the Khronos Data Format Specification.
constexpr std::uint32_t kModelRgba = 1;
constexpr std::uint32_t kModelBc4 = 131;
constexpr std::uint32_t kModelBc5 = 132;
constexpr std::uint32_t kModelBc7 = 134;
constexpr std::uint32_t kPrimariesBt709 = 1;
constexpr std::uint32_t kTransferLinear = 1;
constexpr std::uint32_t kTransferSrgb = 2;
constexpr std::uint32_t kAlphaIsPremultiplied = 1;  // a flag
constexpr std::uint32_t kAlphaChannel = 15;
constexpr std::uint32_t kLinearSample = 0x10;  // flag: the channel is linear, not sRGB

std::uint32_t model_of(PixelFormat format) {
    switch (format) {
        case PixelFormat::Bc4:
            return kModelBc4;
        case PixelFormat::Bc5:
            return kModelBc5;
        case PixelFormat::Bc7:
        case PixelFormat::Bc7Srgb:
            return kModelBc7;
        default:
            return kModelRgba;
    }
}

// Appends the description of a sample: its bits in a texel or block, its channel and its largest
// value.
void append_sample(
    Bytes& bytes, int offset, int bits, std::uint32_t channel, std::uint32_t largest) {
    append_number(bytes,
                  static_cast<std::uint32_t>(offset) | static_cast<std::uint32_t>(bits - 1) << 16U |
                      channel << 24U);
    append_number(bytes, std::uint32_t{0});  // position within the texel
    append_number(bytes, std::uint32_t{0});  // smallest value
    append_number(bytes, largest);
}

Bytes samples_of(const PixelFormatFacts& facts) {
    Bytes samples;
    if (facts.is_compressed) {
        const int count = facts.format == PixelFormat::Bc5 ? 2 : 1;
        const int bits = 8 * static_cast<int>(facts.unit_bytes) / count;
        for (int k = 0; k < count; ++k) {
            append_sample(samples, k * bits, bits, static_cast<std::uint32_t>(k), ~0U);
        }
        return samples;
    }
    for (int channel = 0; channel < facts.channels; ++channel) {
        const bool is_alpha = channel == 3;
        append_sample(samples,
                      channel * facts.bits,
                      facts.bits,
                      is_alpha ? kAlphaChannel | (facts.is_srgb ? kLinearSample : 0)
                               : static_cast<std::uint32_t>(channel),
                      facts.bits == 8 ? 0xffU : 0xffffU);
    }
    return samples;
}

}  // namespace

Bytes data_format_descriptor(PixelFormat format) {
    const PixelFormatFacts& facts = facts_of(format);
    const Bytes samples = samples_of(facts);
    const auto block_bytes = static_cast<std::uint32_t>(24 + samples.size());
    Bytes bytes;
    append_number(bytes, block_bytes + 4);          // size of the descriptor
    append_number(bytes, std::uint32_t{0});         // basic descriptor of Khronos
    append_number(bytes, 2U | block_bytes << 16U);  // version, size of the block
    append_number(bytes,
                  model_of(format) | kPrimariesBt709 << 8U |
                      (facts.is_srgb ? kTransferSrgb : kTransferLinear) << 16U);
    append_number(bytes, facts.is_compressed ? 0x303U : 0U);  // extents of a block, minus 1
    append_number(bytes, static_cast<std::uint32_t>(facts.unit_bytes));
    append_number(bytes, std::uint32_t{0});
    bytes.insert(bytes.end(), samples.begin(), samples.end());
    return bytes;
}

void check_straight_alpha(std::span<const std::byte> descriptor) {
    ByteReader reader(descriptor);
    reader.take(12);                                     // sizes, type and version
    const std::uint32_t flags = reader.number() >> 24U;  // after model, primaries and transfer
    check_supported("KTX2", (flags & kAlphaIsPremultiplied) == 0, "has premultiplied alpha");
}

}  // namespace foam::texgen
