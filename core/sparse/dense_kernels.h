// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

namespace foam {

/// The number of columns of a product that are computed together. The right factor of a product is
/// packed in groups of this many rows.
inline constexpr std::ptrdiff_t kGroup = 4;

/// The largest number of columns that are eliminated directly, without a matrix product.
inline constexpr std::ptrdiff_t kNarrow = 16;

/// Sums over pivots are cut into pieces of this size, so that the factors of a product stay in the
/// cache.
inline constexpr std::ptrdiff_t kLargestDepth = 128;

/// The operands of target −= left · rightᵀ. Only the elements on and below the target's diagonal
/// (row ≥ column) are computed. `left` and `target` are column-major. `right` has as many rows as
/// the target has columns and is packed in groups of kGroup rows. Within a group, the kGroup
/// numbers of each depth are contiguous. The last group is padded with zeros. Precondition: rows ≥
/// cols and depth ≤ kLargestDepth.
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

/// The operands of an elimination that overwrites the matrix A in `target` with L, where A = L D
/// Uᵀ. U is unit lower triangular with `pivots` ≤ kNarrow rows, and D is diagonal. `triangle` holds
/// D on its diagonal and U below it, in the layout that factor_panel produces.
template <class Real>
struct DenseElimination {
    std::ptrdiff_t rows = 0;
    std::ptrdiff_t pivots = 0;
    const Real* triangle = nullptr;
    Real* target = nullptr;
    std::ptrdiff_t stride = 0;  // of `triangle` and `target`
};

// The inner loops of a dense L D Lᵀ for float and double, compiled for each SIMD level and run at
// simd_level(). Each number is computed by the same operations in the same order at every level, so
// that the bits are the same.

template <class Real>
void subtract_product(const DenseProduct<Real>& product);

template <class Real>
void eliminate(const DenseElimination<Real>& elimination);

}  // namespace foam
