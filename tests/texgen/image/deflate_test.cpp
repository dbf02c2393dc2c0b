// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/deflate.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

std::uint8_t* raw(std::span<const std::byte> bytes) {
    return const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

/// Returns the data that zlib decompresses from a deflate stream without a header. Returns no data
/// if the stream is malformed or does not contain exactly `size` bytes.
Bytes inflated(std::span<const std::byte> stream, std::size_t size) {
    Bytes data(size);
    z_stream state{};
    state.next_in = raw(stream);
    state.avail_in = static_cast<unsigned>(stream.size());
    state.next_out = raw(data);
    state.avail_out = static_cast<unsigned>(size);
    inflateInit2(&state, -MAX_WBITS);
    const int result = inflate(&state, Z_FINISH);
    const bool whole = result == Z_STREAM_END && state.avail_in == 0 && state.avail_out == 0;
    inflateEnd(&state);
    return whole ? data : Bytes();
}

Bytes noise(std::size_t size, unsigned seed = 1) {
    std::mt19937 random(seed);
    Bytes data(size);
    for (std::byte& byte : data) {
        byte = static_cast<std::byte>(random() >> 24);
    }
    return data;
}

Bytes runs(std::size_t size) {
    Bytes data(size);
    for (std::size_t k = 0; k < size; ++k) {
        data[k] = static_cast<std::byte>(k / 50 % 7);
    }
    return data;
}

Bytes repeated(const Bytes& begin, std::size_t size) {
    Bytes data(size);
    for (std::size_t k = 0; k < size; ++k) {
        data[k] = begin[k % begin.size()];
    }
    return data;
}

Bytes joined(std::span<const std::byte> first, std::span<const std::byte> second) {
    Bytes both(first.begin(), first.end());
    both.insert(both.end(), second.begin(), second.end());
    return both;
}

class DeflateTest : public testing::TestWithParam<Compression> {};

// Noise cannot be compressed, so its output is the largest possible.
TEST_P(DeflateTest, ZlibInflatesIt) {
    Deflater deflater;
    for (const std::size_t size : {0U, 1U, 1000U, 70'000U, 600'000U}) {
        for (const Bytes& data : {noise(size), runs(size)}) {
            const Bytes back = inflated(deflater.deflate(GetParam(), data), size);
            EXPECT_EQ(back, data) << size;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Compressions,
                         DeflateTest,
                         testing::Values(Compression::None, Compression::Fast, Compression::Small));

TEST(Deflate, PartsInARowAreOneStream) {
    const Bytes data = runs(100'000);
    const std::span<const std::byte> all(data);
    Deflater one;
    Deflater other;
    const auto first = one.deflate(Compression::Fast, all.first(60'001), false);
    const auto second = other.deflate(Compression::Fast, all.subspan(60'001), true);
    EXPECT_EQ(inflated(joined(first, second), data.size()), data);
}

// The 16 deflaters exist at the same time, so they have different addresses. The data are short and
// repeat their first bytes, because in ISA-L 2.30 only the output for the first bytes of a stream
// can depend on the address.
TEST(Deflate, TheBytesDoNotDependOnTheAddressOfTheDeflater) {
    std::vector<Deflater> deflaters(16);
    for (unsigned seed = 1; seed <= 500; ++seed) {
        const std::size_t size = 20 + seed % 64;
        const Bytes data = repeated(noise(size / 4, seed), size);
        const auto first = deflaters.front().deflate(Compression::Fast, data);
        ASSERT_EQ(inflated(first, size), data) << seed;
        const Bytes expected(first.begin(), first.end());
        for (Deflater& deflater : deflaters) {
            const auto stream = deflater.deflate(Compression::Fast, data);
            ASSERT_TRUE(std::ranges::equal(stream, expected)) << seed;
        }
    }
}

// By RFC 1950, s1 is 1 plus the sum of the bytes, and s2 is the sum of the successive values of s1.
// For "ab", s1 = 1 + 97 + 98 = 196 and s2 = 98 + 196 = 294.
TEST(Deflate, ChecksumIsAdler32) {
    const std::string_view text = "ab";
    const auto bytes = std::as_bytes(std::span(text));
    EXPECT_EQ(adler32_of(bytes), 294U << 16 | 196U);
    EXPECT_EQ(adler32_of({}), 1U);
    EXPECT_EQ(joined_adler32(adler32_of(bytes.first(1)), adler32_of(bytes.subspan(1)), 1),
              adler32_of(bytes));
}

}  // namespace
}  // namespace foam::texgen
