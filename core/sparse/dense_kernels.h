#pragma once

#include <cstddef>

namespace foam {

/// Columns of a product that are taken at once; its right factor is packed in groups of so many.
inline constexpr std::ptrdiff_t kGroup = 4;

/// Columns that are eliminated at most without a product.
inline constexpr std::ptrdiff_t kNarrow = 16;

/// The sums over the pivots are cut in pieces of this size, for the caches' sake.
inline constexpr std::ptrdiff_t kLargestDepth = 128;

/// target −= left · rightᵀ, where the target's row is not above its column. All matrices are
/// column-major but the right one, which has as many rows as the target has columns: in groups of
/// kGroup rows, each depth after depth, the last one filled up with zeros. rows ≥ cols and
/// depth ≤ kLargestDepth.
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

/// Rows of a matrix A that become those of L, with A = L D Uᵀ: U is lower unit triangular with
/// `pivots` ≤ kNarrow rows, D diagonal; both stand where partial_ldlt puts them, in `triangle`.
template <class Real>
struct DenseElimination {
    std::ptrdiff_t rows = 0;
    std::ptrdiff_t pivots = 0;
    const Real* triangle = nullptr;
    Real* target = nullptr;
    std::ptrdiff_t stride = 0;  // of both
};

/// The inner loops of a dense L D Lᵀ, for float and double. Each number is computed by the same
/// operations in the same order by the kernels of any machine: the same bits.
template <class Real>
struct DenseKernels {
    void (*subtract_product)(const DenseProduct<Real>&) = nullptr;
    void (*eliminate)(const DenseElimination<Real>&) = nullptr;
};

/// For vectors of 16 bytes.
template <class Real>
DenseKernels<Real> baseline_kernels();

/// For the widest vectors that this machine has.
template <class Real>
DenseKernels<Real> best_kernels();

}  // namespace foam
