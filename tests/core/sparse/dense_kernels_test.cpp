// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dense_kernels.h"

#include "core/parallel/simd_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace foam {
namespace {

template <class Real>
std::vector<Real> random_numbers(std::size_t count) {
    std::mt19937_64 bits(11);
    std::vector<Real> numbers(count);
    for (Real& number : numbers) {
        number = static_cast<Real>(static_cast<double>(bits() >> 11U) * 0x1p-53 - 0.5);
    }
    return numbers;
}

template <class Real>
class DenseKernelsTest : public testing::Test {
  public:
    using Index = std::ptrdiff_t;
    // Odd, so that most columns are not aligned for a vector.
    static constexpr Index kStride = 141;
    static constexpr Index kMaxCols = 64;

    // Returns the target after a product of random numbers. The numbers do not depend on the shape
    // of the product.
    static std::vector<Real> product_of(Index rows, Index cols, Index depth) {
        const std::vector<Real> left = random_numbers<Real>(kStride * kMaxDepth);
        const std::vector<Real> right = random_numbers<Real>(kMaxCols * kMaxDepth);
        std::vector<Real> target = random_numbers<Real>(kStride * kMaxCols);
        subtract_product<Real>({.rows = rows,
                                .cols = cols,
                                .depth = depth,
                                .left = left.data(),
                                .left_stride = kStride,
                                .right = right.data(),
                                .target = target.data(),
                                .target_stride = kStride});
        return target;
    }

    // Returns the result of product_of, computed by a plain loop.
    static std::vector<Real> plain_product(Index rows, Index cols, Index depth) {
        const std::vector<Real> left = random_numbers<Real>(kStride * kMaxDepth);
        const std::vector<Real> right = random_numbers<Real>(kMaxCols * kMaxDepth);
        std::vector<Real> target = random_numbers<Real>(kStride * kMaxCols);
        for (Index col = 0; col < cols; ++col) {
            for (Index row = col; row < rows; ++row) {
                Real sum = 0;
                for (Index k = 0; k < depth; ++k) {
                    const Index group = col / kTileColumns * kTileColumns * depth;
                    sum += at(left, row + k * kStride) *
                           at(right, group + k * kTileColumns + col % kTileColumns);
                }
                target[static_cast<std::size_t>(row + col * kStride)] -= sum;
            }
        }
        return target;
    }

    static void expect_product(Index rows, Index cols, Index depth) {
        const std::vector<Real> expected = plain_product(rows, cols, depth);
        for (const SimdLevel level : available_simd_levels()) {
            const ForcedSimdLevel forced(level);
            EXPECT_EQ(product_of(rows, cols, depth), expected)
                << name_of(level) << ", " << rows << " rows, " << cols << " columns, depth "
                << depth;
        }
    }

    // Returns random numbers after an elimination of the first columns.
    static std::vector<Real> eliminated(Index rows, Index pivots) {
        std::vector<Real> numbers = random_numbers<Real>(kStride * kMaxDirectColumns);
        eliminate<Real>({.rows = rows,
                         .pivots = pivots,
                         .triangle = numbers.data(),
                         .target = numbers.data() + pivots,
                         .stride = kStride});
        return numbers;
    }

    // Returns the result of `eliminated`, computed by a plain loop.
    static std::vector<Real> eliminated_by_loop(Index rows, Index pivots) {
        std::vector<Real> numbers = random_numbers<Real>(kStride * kMaxDirectColumns);
        for (Index row = pivots; row < pivots + rows; ++row) {
            std::vector<Real> y;
            for (Index col = 0; col < pivots; ++col) {
                y.push_back(at(numbers, row + col * kStride));
                for (Index k = 0; k < col; ++k) {
                    y.back() -= at(y, k) * at(numbers, col + k * kStride);
                }
            }
            for (Index col = 0; col < pivots; ++col) {
                const Real inverse = Real(1) / at(numbers, col + col * kStride);
                numbers[static_cast<std::size_t>(row + col * kStride)] = at(y, col) * inverse;
            }
        }
        return numbers;
    }

  private:
    static Real at(const std::vector<Real>& numbers, Index index) {
        return numbers[static_cast<std::size_t>(index)];
    }
};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(DenseKernelsTest, Reals);

// Numbers above the diagonal or outside of the target must stay unchanged.
TYPED_TEST(DenseKernelsTest, MultiplyAsAPlainLoopDoesToTheBit) {
    for (const std::ptrdiff_t rows : {1, 3, 4, 8, 13, 24, 31, 64, 131}) {
        for (const std::ptrdiff_t cols : {1, 2, 4, 7, 33, 64}) {
            for (const std::ptrdiff_t depth : {1, 17, 128}) {
                this->expect_product(rows, std::min(rows, cols), depth);
            }
        }
    }
}

TYPED_TEST(DenseKernelsTest, EliminateAsAPlainLoopDoesToTheBit) {
    for (const std::ptrdiff_t rows : {0, 1, 4, 7, 8, 29, 120}) {
        for (const std::ptrdiff_t pivots : {1, 2, 9, 16}) {
            const auto expected = this->eliminated_by_loop(rows, pivots);
            for (const SimdLevel level : available_simd_levels()) {
                const ForcedSimdLevel forced(level);
                EXPECT_EQ(this->eliminated(rows, pivots), expected)
                    << name_of(level) << ", " << rows << " rows, " << pivots << " pivots";
            }
        }
    }
}

}  // namespace
}  // namespace foam
