// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

namespace foam {

/// The number of columns of a product that are computed together. DenseProduct::right is packed in
/// groups of this many rows.
inline constexpr std::ptrdiff_t kTileColumns = 4;

/// The largest number of columns that are eliminated directly, without a matrix product.
inline constexpr std::ptrdiff_t kMaxDirectColumns = 16;

/// The largest depth of a product (DenseProduct): the largest number of terms of its sums. Longer
/// sums are cut into pieces of this size, so that the factors of a product stay in the cache.
inline constexpr std::ptrdiff_t kMaxDepth = 128;

/// The operands of target −= left · rightᵀ. The target has `rows` rows and `cols` columns, `left`
/// is rows × depth, and `right` is cols × depth. Only the elements on and below the target's
/// diagonal (row ≥ column) are computed. `left` and `target` are column-major; a stride is the
/// distance between columns. `right` is packed in groups of kTileColumns rows. The groups are
/// stored one after the other, each of them column-major. The last group is padded with zero rows.
/// Preconditions: rows ≥ cols and depth ≤ kMaxDepth.
template <class Real>
struct DenseProduct {
    std::ptrdiff_t rows = 0;
    std::ptrdiff_t cols = 0;
    std::ptrdiff_t depth = 0;
    const Real* left = nullptr;
    std::ptrdiff_t left_stride = 0;
    const Real* right = nullptr;
    Real* target = nullptr;
    std::ptrdiff_t target_stride = 0;
};

/// The operands of an elimination that overwrites the matrix A in `target` with the matrix L, where
/// A = L D Uᵀ. A and L are rows × pivots. U is a unit lower triangular matrix of `pivots` rows, and
/// D is diagonal. `triangle` holds D on its diagonal and U below it, as in a factored panel
/// (factor_panel). `triangle` and `target` are column-major.
/// Precondition: pivots ≤ kMaxDirectColumns.
template <class Real>
struct DenseElimination {
    std::ptrdiff_t rows = 0;
    std::ptrdiff_t pivots = 0;
    const Real* triangle = nullptr;
    Real* target = nullptr;
    std::ptrdiff_t stride = 0;  // distance between columns of `triangle` and of `target`
};

// The functions below are the inner loops of a dense L D Lᵀ factorization. They are instantiated
// for float and double, compiled for each SIMD level and run at simd_level(). Each element is
// computed by the same operations in the same order at every level, so that the bits are the same.

/// Subtracts the product left · rightᵀ from the target (DenseProduct).
template <class Real>
void subtract_product(const DenseProduct<Real>& product);

/// Overwrites A with L (DenseElimination).
template <class Real>
void eliminate(const DenseElimination<Real>& elimination);

}  // namespace foam
