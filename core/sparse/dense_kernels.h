#pragma once

#include <cstddef>

namespace foam {

/// The number of columns of a product that are computed together; its right factor is packed in
/// groups of this size.
inline constexpr std::ptrdiff_t kGroup = 4;

/// The largest number of columns that are eliminated without a product.
inline constexpr std::ptrdiff_t kNarrow = 16;

/// Sums over pivots are cut into pieces of this size, so that the factors stay in the cache.
inline constexpr std::ptrdiff_t kLargestDepth = 128;

/// target −= left · rightᵀ, where the target's row is not above its column. All matrices are
/// column-major except the right factor, which has as many rows as the target has columns: it is
/// packed in groups of kGroup rows, each depth after depth, and the last group is padded with
/// zeros. Precondition: rows ≥ cols and depth ≤ kLargestDepth.
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

/// Turns rows of a matrix A into rows of L, where A = L D Uᵀ: U is lower unit triangular with
/// `pivots` ≤ kNarrow rows, D is diagonal; both are stored in `triangle` as factor_panel leaves
/// them.
template <class Real>
struct DenseElimination {
    std::ptrdiff_t rows = 0;
    std::ptrdiff_t pivots = 0;
    const Real* triangle = nullptr;
    Real* target = nullptr;
    std::ptrdiff_t stride = 0;  // of both
};

// The inner loops of a dense L D Lᵀ, for float and double, at simd_level(). Each number is computed
// by the same operations in the same order at every level, so that the bits are the same.

template <class Real>
void subtract_product(const DenseProduct<Real>& product);

template <class Real>
void eliminate(const DenseElimination<Real>& elimination);

}  // namespace foam
