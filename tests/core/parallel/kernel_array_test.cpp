// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/kernel_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>

namespace foam {
namespace {

TEST(KernelArray, BeginsWithZeros) {
    const KernelArray<double, 5> array;
    EXPECT_EQ(array.size(), 5U);
    EXPECT_EQ(std::count(array.begin(), array.end(), 0.0), 5);
}

TEST(KernelArray, FillsAllElementsAndNoOthers) {
    KernelArray<KernelArray<int, 3>, 3> arrays;
    arrays[1].fill(7);
    EXPECT_EQ(std::count(arrays[0].begin(), arrays[0].end(), 0), 3);
    EXPECT_EQ(std::count(arrays[1].begin(), arrays[1].end(), 7), 3);
    EXPECT_EQ(std::count(arrays[2].begin(), arrays[2].end(), 0), 3);
}

// Kernels copy whole arrays, and pass pointers to their elements.
TEST(KernelArray, IsCopiedAndStoredAsAPlainArray) {
    static_assert(std::is_trivially_copyable_v<KernelArray<float, 16>>);
    static_assert(sizeof(KernelArray<float, 16>) == 16 * sizeof(float));
    KernelArray<int, 2> first = {{3, 4}};
    const KernelArray<int, 2> copy = first;
    first.data()[1] = 5;
    EXPECT_EQ(first[1], 5);
    EXPECT_EQ(copy[1], 4);
    EXPECT_EQ(copy.data() + 2, copy.end());
}

}  // namespace
}  // namespace foam
