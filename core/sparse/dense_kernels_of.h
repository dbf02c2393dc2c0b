#pragma once

#include "core/sparse/dense_kernels.h"

#include <cstring>

// Included by one source for each width of vectors, each compiled for the machines that have them.
// So all here is a template on the width, and nothing else with code may be included: a function
// that two of the sources had in common could end up compiled for the wrong machine.

namespace foam::kernels {

/// As many numbers as fill a vector of the machine's, with the arithmetic of vectors.
template <class Real, int Bytes>
using Vector [[gnu::vector_size(Bytes)]] = Real;

template <class Real, int Bytes>
struct Kernels {
    using Lanes = Vector<Real, Bytes>;
    using Index = std::ptrdiff_t;

    static constexpr Index kLanes = Bytes / Index{sizeof(Real)};
    static constexpr Index kLargestStrip = 3;  // vectors, of a strip of rows

    static void subtract_product(const DenseProduct<Real>& product) {
        Index row = 0;
        for (; row + kLargestStrip * kLanes <= product.rows; row += kLargestStrip * kLanes) {
            subtract_strip<kLargestStrip>(product, row);
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

    // NOLINTBEGIN(*-avoid-c-arrays): std::array's functions are those that must not be shared.
    template <Index Strip>
    struct Tile {
        Lanes sums[size(kGroup)][size(Strip)];
    };

    static Lanes load(const Real* source) {
        Lanes lanes;
        std::memcpy(&lanes, source, sizeof lanes);
        return lanes;
    }

    static void store(Real* target, const Lanes& lanes) {
        std::memcpy(target, &lanes, sizeof lanes);
    }

    static Lanes load(const Real* source, Index count) {
        Lanes lanes = {};
        std::memcpy(&lanes, source, size(count) * sizeof(Real));
        return lanes;
    }

    static void store(Real* target, const Lanes& lanes, Index count) {
        std::memcpy(target, &lanes, size(count) * sizeof(Real));
    }

    template <Index Strip>
    static Tile<Strip> multiply(const Real* left, Index stride, const Real* right, Index depth) {
        Tile<Strip> tile = {};
        for (Index k = 0; k < depth; ++k) {
            Lanes rows[size(Strip)];
            for (Index part = 0; part < Strip; ++part) {
                rows[part] = load(left + k * stride + part * kLanes);
            }
            for (Index col = 0; col < kGroup; ++col) {
                for (Index part = 0; part < Strip; ++part) {
                    tile.sums[col][part] += rows[part] * right[k * kGroup + col];
                }
            }
        }
        return tile;
    }

    template <Index Strip>
    static void subtract_strip(const DenseProduct<Real>& product, Index row) {
        const Index end = row + Strip * kLanes;
        for (Index col = 0; col < product.cols && col < end; col += kGroup) {
            const Tile<Strip> tile = multiply<Strip>(product.left + row,
                                                     product.left_stride,
                                                     product.right + col * product.depth,
                                                     product.depth);
            subtract_tile(product, tile, row, end, col);
        }
    }

    // The last rows, fewer than a vector holds, are copied to where a whole vector can be read.
    static void subtract_last_rows(const DenseProduct<Real>& product, Index row) {
        Real rows[size(kLargestDepth * kLanes)];
        for (Index k = 0; k < product.depth; ++k) {
            const Lanes lanes =
                load(product.left + row + k * product.left_stride, product.rows - row);
            store(rows + k * kLanes, lanes);
        }
        for (Index col = 0; col < product.cols; col += kGroup) {
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
        for (Index k = 0; k < kGroup && first_col + k < product.cols; ++k) {
            const Index col = first_col + k;
            Real* target = product.target + col * product.target_stride;
            if (is_whole && col <= row) {
                for (Index part = 0; part < Strip; ++part) {
                    Real* const place = target + row + part * kLanes;
                    store(place, load(place) - tile.sums[k][part]);
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

    // y = L D column by column, each out of the columns before it; then L.
    static void eliminate_strip(const DenseElimination<Real>& elimination, Index row, Index count) {
        Lanes y[size(kNarrow)];
        for (Index col = 0; col < elimination.pivots; ++col) {
            const Real* const source = elimination.target + row + col * elimination.stride;
            Lanes sum = count == kLanes ? load(source) : load(source, count);
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
    // NOLINTEND(*-avoid-c-arrays)
};

template <class Real, int Bytes>
DenseKernels<Real> kernels_of() {
    return {Kernels<Real, Bytes>::subtract_product, Kernels<Real, Bytes>::eliminate};
}

}  // namespace foam::kernels
