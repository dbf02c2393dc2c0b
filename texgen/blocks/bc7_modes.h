// SPDX-License-Identifier: Apache-2.0

#pragma once

// Facts about the modes 1, 5 and 6 of BC7, from the Khronos Data Format Specification 1.3, chapter
// "BPTC Compressed Texture Image Formats". A block of mode m begins with m zero bits and a one bit.
//
// Mode 1: 6 bits for the partition, then the endpoints of two subsets (6 bits per color channel;
// alpha is 255), one shared lowest bit per subset, and indices of 3 bits.
// Mode 5: 2 bits for the rotation of channels, then two endpoints (7 bits per color channel, 8 bits
// for alpha), indices of 2 bits for colors, and indices of 2 bits for alpha.
// Mode 6: two endpoints (7 bits per channel), one lowest bit per endpoint, and indices of 4 bits.
//
// Endpoints are stored channel by channel. The highest bit of the index of an anchor texel is 0 and
// not stored. The first texel of a subset is its anchor, except that kSecondAnchors has the anchors
// of the second subset.

#include "texgen/blocks/texel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen::bc7 {

/// The weights, in 64ths, that indices of 2, 3 and 4 bits give to the second endpoint.
inline constexpr std::array<int, 4> kWeights2 = {0, 21, 43, 64};
inline constexpr std::array<int, 8> kWeights3 = {0, 9, 18, 27, 37, 46, 55, 64};
inline constexpr std::array<int, 16> kWeights4 = {
    0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};

/// Returns the value between two endpoints of 8 bits for a weight of the second one.
constexpr int interpolated(int first, int second, int weight) {
    return ((64 - weight) * first + weight * second + 32) >> 6;
}

/// Returns the 8 bits that an endpoint of 7 bits stands for.
constexpr int expanded7(int bits) {
    return (bits << 1) | (bits >> 6);
}

inline constexpr int kPartitions = 64;

/// The partitions of 16 texels into two subsets. Bit k is set if texel k is in the second subset.
inline constexpr std::array<std::uint16_t, kPartitions> kPartitionMasks = {
    0xcccc, 0x8888, 0xeeee, 0xecc8, 0xc880, 0xfeec, 0xfec8, 0xec80, 0xc800, 0xffec, 0xfe80,
    0xe800, 0xffe8, 0xff00, 0xfff0, 0xf000, 0xf710, 0x008e, 0x7100, 0x08ce, 0x008c, 0x7310,
    0x3100, 0x8cce, 0x088c, 0x3110, 0x6666, 0x366c, 0x17e8, 0x0ff0, 0x718e, 0x399c, 0xaaaa,
    0xf0f0, 0x5a5a, 0x33cc, 0x3c3c, 0x55aa, 0x9696, 0xa55a, 0x73ce, 0x13c8, 0x324c, 0x3bdc,
    0x6996, 0xc33c, 0x9966, 0x0660, 0x0272, 0x04e4, 0x4e40, 0x2720, 0xc936, 0x936c, 0x39c6,
    0x639c, 0x9336, 0x9cc6, 0x817e, 0xe718, 0xccf0, 0x0fcc, 0x7744, 0xee22};

/// The anchor texel of the second subset of each partition.
inline constexpr std::array<std::uint8_t, kPartitions> kSecondAnchors = {
    15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 2,  8, 2, 2, 8,
    8,  15, 2,  8,  2,  2,  8,  8,  2,  2,  15, 15, 6,  8,  2,  8,  15, 15, 2, 8, 2, 2,
    2,  15, 15, 6,  6,  2,  6,  8,  15, 15, 2,  2,  15, 15, 15, 15, 15, 2,  2, 15};

}  // namespace foam::texgen::bc7
