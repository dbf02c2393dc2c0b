// SPDX-License-Identifier: Apache-2.0

#pragma once

// Facts about BC7 from the Khronos Data Format Specification 1.3, chapter "BPTC Compressed Texture
// Image Formats".
//
// A block of mode m begins with m zero bits and a one bit. A partition divides its texels into two
// or three subsets; in the modes 4, 5 and 6, all texels are one subset. Each subset has two
// endpoints, which are colors of few bits. An index per texel selects the weight of the second
// endpoint (weight_of), and so a color between the endpoints. Endpoints are stored channel by
// channel. In the modes 4 and 5, alpha has indices of its own, and a rotation may exchange alpha
// with another channel. Each subset has one anchor texel. The highest bit of the index of this
// texel is always 0 and is not stored. Texel 0 is the anchor of the first subset.

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace foam::texgen::bc7 {

/// The lowest bits of endpoints, called P-bits in the specification. All channels of an endpoint
/// share one bit.
enum class LowestBits : std::uint8_t {
    None,
    PerEndpoint,
    PerSubset,  // both endpoints of a subset share one bit
    // The bits of both endpoints are 1. The encoder uses this value for opaque blocks in mode 6. In
    // this mode, an endpoint can have the alpha 255 only if its lowest bit is 1.
    Ones,
};

/// The fields of a mode. All numbers except `subsets` are numbers of bits.
struct Mode {
    int subsets = 1;
    int partition_bits = 0;
    int rotation_bits = 0;
    int selection_bits = 0;  // 1: a bit tells whether colors and alpha exchange their indices
    int color_bits = 0;      // per channel of an endpoint, without the bit of `lowest`
    int alpha_bits = 0;      // per endpoint, without the bit of `lowest`; 0: all texels are opaque
    LowestBits lowest = LowestBits::None;
    int index_bits = 0;
    int alpha_index_bits = 0;  // 0: the indices of colors are also those of alpha
};

inline constexpr std::array<Mode, 8> kModes = {{
    {3, 4, 0, 0, 4, 0, LowestBits::PerEndpoint, 3, 0},
    {2, 6, 0, 0, 6, 0, LowestBits::PerSubset, 3, 0},
    {3, 6, 0, 0, 5, 0, LowestBits::None, 2, 0},
    {2, 6, 0, 0, 7, 0, LowestBits::PerEndpoint, 2, 0},
    {1, 0, 2, 1, 5, 6, LowestBits::None, 2, 3},
    {1, 0, 2, 0, 7, 8, LowestBits::None, 2, 2},
    {1, 0, 0, 0, 7, 7, LowestBits::PerEndpoint, 4, 0},
    {2, 6, 0, 0, 5, 5, LowestBits::PerEndpoint, 2, 0},
}};

/// The number of partitions into two subsets, and of those into three.
inline constexpr int kPartitions = 64;

/// The partitions into two subsets. Bit k is set if texel k is in the second subset.
inline constexpr std::array<std::uint16_t, kPartitions> kPartitionMasks = {
    0xcccc, 0x8888, 0xeeee, 0xecc8, 0xc880, 0xfeec, 0xfec8, 0xec80, 0xc800, 0xffec, 0xfe80,
    0xe800, 0xffe8, 0xff00, 0xfff0, 0xf000, 0xf710, 0x008e, 0x7100, 0x08ce, 0x008c, 0x7310,
    0x3100, 0x8cce, 0x088c, 0x3110, 0x6666, 0x366c, 0x17e8, 0x0ff0, 0x718e, 0x399c, 0xaaaa,
    0xf0f0, 0x5a5a, 0x33cc, 0x3c3c, 0x55aa, 0x9696, 0xa55a, 0x73ce, 0x13c8, 0x324c, 0x3bdc,
    0x6996, 0xc33c, 0x9966, 0x0660, 0x0272, 0x04e4, 0x4e40, 0x2720, 0xc936, 0x936c, 0x39c6,
    0x639c, 0x9336, 0x9cc6, 0x817e, 0xe718, 0xccf0, 0x0fcc, 0x7744, 0xee22};

/// The partitions into three subsets. Bits 2k and 2k + 1 are the number of the subset of texel k.
inline constexpr std::array<std::uint32_t, kPartitions> kThreeSubsets = {
    0xaa685050, 0x6a5a5040, 0x5a5a4200, 0x5450a0a8, 0xa5a50000, 0xa0a05050, 0x5555a0a0, 0x5a5a5050,
    0xaa550000, 0xaa555500, 0xaaaa5500, 0x90909090, 0x94949494, 0xa4a4a4a4, 0xa9a59450, 0x2a0a4250,
    0xa5945040, 0x0a425054, 0xa5a5a500, 0x55a0a0a0, 0xa8a85454, 0x6a6a4040, 0xa4a45000, 0x1a1a0500,
    0x0050a4a4, 0xaaa59090, 0x14696914, 0x69691400, 0xa08585a0, 0xaa821414, 0x50a4a450, 0x6a5a0200,
    0xa9a58000, 0x5090a0a8, 0xa8a09050, 0x24242424, 0x00aa5500, 0x24924924, 0x24499224, 0x50a50a50,
    0x500aa550, 0xaaaa4444, 0x66660000, 0xa5a0a5a0, 0x50a050a0, 0x69286928, 0x44aaaa44, 0x66666600,
    0xaa444444, 0x54a854a8, 0x95809580, 0x96969600, 0xa85454a8, 0x80959580, 0xaa141414, 0x96960000,
    0xaaaa1414, 0xa05050a0, 0xa0a5a5a0, 0x96000000, 0x40804080, 0xa9a8a9a8, 0xaaaaaa44, 0x2a4a5254};

/// The anchor texel of the second subset of each partition into two subsets.
inline constexpr std::array<std::uint8_t, kPartitions> kSecondAnchors = {
    15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 2,  8, 2, 2, 8,
    8,  15, 2,  8,  2,  2,  8,  8,  2,  2,  15, 15, 6,  8,  2,  8,  15, 15, 2, 8, 2, 2,
    2,  15, 15, 6,  6,  2,  6,  8,  15, 15, 2,  2,  15, 15, 15, 15, 15, 2,  2, 15};

/// The anchor texels of the second and of the third subset of each partition into three subsets.
inline constexpr std::array<std::array<std::uint8_t, kPartitions>, 2> kAnchorsOfThree = {
    {{3,  3,  15, 15, 8, 3,  15, 15, 8,  8,  6, 6,  6, 5,  3, 3,  3,  3,  8,  15, 3,  3,
      6,  10, 5,  8,  8, 6,  8,  5,  15, 15, 8, 15, 3, 5,  6, 10, 8,  15, 15, 3,  15, 5,
      15, 15, 15, 15, 3, 15, 5,  5,  5,  8,  5, 10, 5, 10, 8, 13, 15, 12, 3,  3},
     {15, 8, 8, 3,  15, 15, 3,  8,  15, 15, 15, 15, 15, 15, 15, 8,  15, 8,  15, 3,  15, 8,
      15, 8, 3, 15, 6,  10, 15, 15, 10, 8,  15, 3,  15, 10, 10, 8,  9,  10, 6,  15, 8,  15,
      3,  6, 6, 8,  15, 3,  15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 3,  15, 15, 8}}};

/// Returns the number of the subset of a texel in a partition into 1, 2 or 3 subsets.
constexpr int subset_of(int subsets, int partition, int texel) {
    const auto index = static_cast<std::size_t>(partition);
    if (subsets == 2) {
        return kPartitionMasks[index] >> texel & 1;
    }
    return subsets == 3 ? static_cast<int>(kThreeSubsets[index] >> 2 * texel & 3U) : 0;
}

/// Returns the anchor texel of a subset.
constexpr int anchor_of(int subsets, int partition, int subset) {
    const auto index = static_cast<std::size_t>(partition);
    if (subset == 0) {
        return 0;
    }
    return subsets == 2 ? kSecondAnchors[index]
                        : kAnchorsOfThree[static_cast<std::size_t>(subset - 1)][index];
}

/// Returns the weight of the second endpoint, in 64ths, for an index of 2, 3 or 4 bits: 64 times
/// the index divided by the largest index, rounded to the nearest integer.
constexpr int weight_of(int index, int index_bits) {
    const int largest = (1 << index_bits) - 1;
    return (128 * index + largest) / (2 * largest);
}

/// Returns the value between two endpoints of 8 bits for a weight of the second one.
constexpr int interpolated(int first, int second, int weight) {
    return ((64 - weight) * first + weight * second + 32) >> 6;
}

/// Returns the value of 8 bits that an endpoint of `bits` bits stands for: the bits of the
/// endpoint, followed by a repetition of its highest bits. Precondition: 4 <= `bits` <= 8.
constexpr int expanded(int code, int bits) {
    const int high = code << (8 - bits);
    return high | high >> bits;
}

}  // namespace foam::texgen::bc7
