// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dense_kernels.h"

#include "core/parallel/simd_level.h"

#include <cstring>

namespace foam {

// A product left · rightᵀ (DenseProduct) is computed in tiles that fit in registers. A tile has
// kTileColumns columns and as many rows as one, two or three SIMD vectors have lanes. It is summed
// over the whole depth in registers and is then subtracted from the target. Each element is summed
// in one lane, in the order of the columns of `left` and `right`. The width of the vectors
// therefore does not change any bit of the result.

namespace {

// A SIMD vector of `Bytes` bytes, with element-wise arithmetic.
template <class Real, int Bytes>
using Vector [[gnu::vector_size(Bytes)]] = Real;

// The loops for one vector width.
template <class Real, int Bytes>
struct Kernels {
    using Lanes = Vector<Real, Bytes>;
    // Lanes at an address that is aligned for a Real only. A pointer to this type is dereferenced
    // instead of calling memcpy, because GCC 12 copies 32 bytes as two halves. Reading them as a
    // whole then waits until both halves are written, which made factoring up to twice as slow.
    using LanesInMemory [[gnu::aligned(alignof(Real)), gnu::may_alias]] = Lanes;
    static_assert(alignof(LanesInMemory) == alignof(Real));
    using Index = std::ptrdiff_t;

    static constexpr Index kLanes = Bytes / Index{sizeof(Real)};
    static constexpr Index kMaxStrip = 3;  // largest height of a strip of rows, in vectors

    static void subtract_product(const DenseProduct<Real>& product) {
        Index row = 0;
        for (; row + kMaxStrip * kLanes <= product.rows; row += kMaxStrip * kLanes) {
            subtract_strip<kMaxStrip>(product, row);
        }
        if (row + 2 * kLanes <= product.rows) {
            subtract_strip<2>(product, row);
            row += 2 * kLanes;
        }
        if (row + kLanes <= product.rows) {
            subtract_strip<1>(product, row);
            row += kLanes;
        }
        if (row < product.rows) {
            subtract_last_rows(product, row);
        }
    }

    static void eliminate(const DenseElimination<Real>& elimination) {
        Index row = 0;
        for (; row + kLanes <= elimination.rows; row += kLanes) {
            eliminate_strip(elimination, row, kLanes);
        }
        if (row < elimination.rows) {
            eliminate_strip(elimination, row, elimination.rows - row);
        }
    }

  private:
    static constexpr std::size_t size(Index count) { return static_cast<std::size_t>(count); }

    template <Index Strip>
    struct Tile {
        Lanes sums[size(kTileColumns)][size(Strip)];
    };

    // SIMD vectors are passed by reference. The way in which a vector is passed by value depends on
    // the instruction set for which a function is compiled. The functions below are compiled for
    // the SIMD level only where at_simd_level inlines them. A call that is not inlined could
    // therefore pass a vector in another way than the called function expects.
    static void load(const Real* source, Lanes& lanes) {
        lanes = *reinterpret_cast<const LanesInMemory*>(source);
    }

    static void store(Real* target, const Lanes& lanes) {
        *reinterpret_cast<LanesInMemory*>(target) = lanes;
    }

    static void load(const Real* source, Index count, Lanes& lanes) {
        lanes = Lanes{};
        std::memcpy(&lanes, source, size(count) * sizeof(Real));
    }

    static void store(Real* target, const Lanes& lanes, Index count) {
        std::memcpy(target, &lanes, size(count) * sizeof(Real));
    }

    template <Index Strip>
    static Tile<Strip> multiply(const Real* left, Index stride, const Real* right, Index depth) {
        // Cleared element by element, because GCC would otherwise clear it in memory first.
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
        Tile<Strip> tile;
        for (auto& column : tile.sums) {
            for (Lanes& sum : column) {
                sum = Lanes{};
            }
        }
        for (Index k = 0; k < depth; ++k) {
            Lanes rows[size(Strip)];
            for (Index part = 0; part < Strip; ++part) {
                load(left + k * stride + part * kLanes, rows[part]);
            }
            for (Index col = 0; col < kTileColumns; ++col) {
                for (Index part = 0; part < Strip; ++part) {
                    tile.sums[col][part] += rows[part] * right[k * kTileColumns + col];
                }
            }
        }
        return tile;
    }

    template <Index Strip>
    static void subtract_strip(const DenseProduct<Real>& product, Index row) {
        const Index end = row + Strip * kLanes;
        for (Index col = 0; col < product.cols && col < end; col += kTileColumns) {
            const Tile<Strip> tile = multiply<Strip>(product.left + row,
                                                     product.left_stride,
                                                     product.right + col * product.depth,
                                                     product.depth);
            subtract_tile(product, tile, row, end, col);
        }
    }

    // Processes the last rows, which are fewer than the lanes of a vector. Copies the rows of
    // `left` into a buffer of whole vectors.
    static void subtract_last_rows(const DenseProduct<Real>& product, Index row) {
        Real rows[size(kMaxDepth * kLanes)];
        for (Index k = 0; k < product.depth; ++k) {
            Lanes lanes;
            load(product.left + row + k * product.left_stride, product.rows - row, lanes);
            store(rows + k * kLanes, lanes);
        }
        for (Index col = 0; col < product.cols; col += kTileColumns) {
            const Tile<1> tile =
                multiply<1>(rows, kLanes, product.right + col * product.depth, product.depth);
            subtract_tile(product, tile, row, product.rows, col);
        }
    }

    template <Index Strip>
    static void subtract_tile(const DenseProduct<Real>& product,
                              const Tile<Strip>& tile,
                              Index row,
                              Index end,
                              Index first_col) {
        const bool is_whole = end == row + Strip * kLanes;
        for (Index k = 0; k < kTileColumns && first_col + k < product.cols; ++k) {
            const Index col = first_col + k;
            Real* target = product.target + col * product.target_stride;
            if (is_whole && col <= row) {
                for (Index part = 0; part < Strip; ++part) {
                    Real* const own = target + row + part * kLanes;
                    Lanes lanes;
                    load(own, lanes);
                    store(own, lanes - tile.sums[k][part]);
                }
            } else {
                Real sums[size(Strip * kLanes)];
                std::memcpy(sums, tile.sums[k], sizeof sums);
                for (Index r = col > row ? col : row; r < end; ++r) {
                    target[r] -= sums[r - row];
                }
            }
        }
    }

    // Processes `count` rows from `row` on (DenseElimination). Precondition: count ≤ kLanes.
    // Computes the columns of y = L D one after another, each column from the columns before it.
    // Then computes L from y.
    static void eliminate_strip(const DenseElimination<Real>& elimination, Index row, Index count) {
        Lanes y[size(kMaxDirectColumns)];
        for (Index col = 0; col < elimination.pivots; ++col) {
            const Real* const source = elimination.target + row + col * elimination.stride;
            Lanes sum;
            if (count == kLanes) {
                load(source, sum);
            } else {
                load(source, count, sum);
            }
            for (Index k = 0; k < col; ++k) {
                sum -= y[k] * elimination.triangle[col + k * elimination.stride];
            }
            y[col] = sum;
        }
        for (Index col = 0; col < elimination.pivots; ++col) {
            const Real pivot = elimination.triangle[col + col * elimination.stride];
            Real* const target = elimination.target + row + col * elimination.stride;
            const Lanes lanes = y[col] * (Real(1) / pivot);
            if (count == kLanes) {
                store(target, lanes);
            } else {
                store(target, lanes, count);
            }
        }
    }
};

// At the level Avx512, vectors have 32 bytes as at the level Avx2, but there are twice as many
// registers for them.
template <class Real, SimdLevel Level>
using KernelsAt = Kernels<Real, Level == SimdLevel::Baseline ? 16 : 32>;

}  // namespace

template <class Real>
void subtract_product(const DenseProduct<Real>& product) {
    at_simd_level([product](auto level) { KernelsAt<Real, level>::subtract_product(product); });
}

template <class Real>
void eliminate(const DenseElimination<Real>& elimination) {
    at_simd_level([elimination](auto level) { KernelsAt<Real, level>::eliminate(elimination); });
}

template void subtract_product(const DenseProduct<float>&);
template void subtract_product(const DenseProduct<double>&);
template void eliminate(const DenseElimination<float>&);
template void eliminate(const DenseElimination<double>&);

}  // namespace foam
