// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/memory.h"

#include <gtest/gtest.h>

#include <limits>

namespace foam::texgen {
namespace {

TEST(Memory, AmountsHaveUnits) {
    EXPECT_EQ(amount_of_bytes(0), "0.0 MB");
    EXPECT_EQ(amount_of_bytes(999'000'000), "999.0 MB");
    EXPECT_EQ(amount_of_bytes(1'550'000'000), "1.6 GB");
}

TEST(Memory, SomeMemoryIsAvailable) {
    EXPECT_GT(available_memory(), 1'000'000U);
    EXPECT_NO_THROW(require_memory(1, "a byte"));
}

TEST(Memory, TooLittleMemoryIsReported) {
    try {
        require_memory(std::numeric_limits<std::uint64_t>::max(), "a test");
        FAIL() << "the memory was accepted";
    } catch (const OutOfMemory& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("a test needs 18446744073.7 GB of memory, but only "))
            << message;
        EXPECT_TRUE(message.ends_with("B are available")) << message;
    }
}

}  // namespace
}  // namespace foam::texgen
