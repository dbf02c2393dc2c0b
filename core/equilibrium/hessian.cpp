// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/hessian.h"

#include "core/geometry/bulge_energy.h"
#include "core/geometry/film_energy.h"
#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <span>

namespace foam {

// The matrix is assembled as in a finite element method: each film contributes a small dense
// matrix, the second derivatives of its term in L (E3). This film matrix is 6 x 6 for an inner film
// and 7 x 7 for an outer film, whose half angle is an unknown. The blocks of the film matrices are
// added at precomputed positions of the compressed column storage. The derivatives of inner films
// are evaluated in parallel. The sums are taken in the order of the films, so that their bits do
// not depend on the number of threads.

namespace {

constexpr std::size_t kFilmsPerChunk = 1024;

using FilmMatrix = Eigen::Matrix<double, 6, 6>;
using OuterFilmMatrix = Eigen::Matrix<double, 7, 7>;

// The number of rows of each node in a film's matrix. The nodes are the tail, the head, the left
// pressure, the right pressure, and the half angle.
constexpr std::array<int, 5> kFilmRows = {2, 2, 1, 1, 1};
// The first row of each node in a film's matrix.
constexpr std::array<int, 5> kFirstFilmRow = {0, 2, 4, 5, 6};

// Returns the second derivatives of one film's term in L, including its polygon terms (E3). The
// variables are the tail, the head, the left pressure and the right pressure. The derivatives of
// the polygon terms at an end with respect to the same end are left out, because they add up to 0
// for the three films at a junction. `d` is the chord, and `delta` is the left pressure minus the
// right pressure.
FilmMatrix film_matrix(const Vec2& d, double delta, const FilmEnergyHessian& hessian) {
    Mat2 turn_right;
    turn_right << 0.0, 1.0, -1.0, 0.0;
    const Mat2 polygon = -0.5 * delta * turn_right;
    // The polygon terms of the gradient at each end, per unit of the pressure difference.
    const Vec2 polygon_gradient = -0.5 * turn_right * d;
    FilmMatrix m = FilmMatrix::Zero();
    m.block<2, 2>(0, 0) = hessian.chord_chord;
    m.block<2, 2>(2, 2) = hessian.chord_chord;
    m.block<2, 2>(0, 2) = polygon - hessian.chord_chord;
    m.block<2, 2>(2, 0) = m.block<2, 2>(0, 2).transpose();
    m.block<2, 1>(0, 4) = polygon_gradient - hessian.chord_pressure;
    m.block<2, 1>(2, 4) = polygon_gradient + hessian.chord_pressure;
    m.block<4, 1>(0, 5) = -m.block<4, 1>(0, 4);
    m.block<2, 4>(4, 0) = m.block<4, 2>(0, 4).transpose();
    m(4, 4) = m(5, 5) = hessian.pressure_pressure;
    m(4, 5) = m(5, 4) = -hessian.pressure_pressure;
    return m;
}

// Returns the second derivatives of an outer film's term in L, with the half angle as the last row.
OuterFilmMatrix outer_film_matrix(const Vec2& d, double delta, const BulgeEnergyHessian& hessian) {
    OuterFilmMatrix m = OuterFilmMatrix::Zero();
    m.topLeftCorner<6, 6>() =
        film_matrix(d, delta, {hessian.chord_chord, hessian.chord_pressure, 0.0});
    m.block<2, 1>(0, 6) = -hessian.chord_angle;
    m.block<2, 1>(2, 6) = hessian.chord_angle;
    m(4, 6) = hessian.pressure_angle;
    m(5, 6) = -hessian.pressure_angle;
    m.block<1, 6>(6, 0) = m.block<6, 1>(0, 6).transpose();
    m(6, 6) = hessian.angle_angle;
    return m;
}

// Adds one block of a film's matrix to `values`. The block has the rows of the first node of the
// pair and the columns of the second node. `values` points to the first value of the block in the
// Hessian. `stride` is FilmSlots::strides[b] for the second node b. `is_on_diagonal` is true if the
// two nodes of the pair are the same node of the Hessian. This is so if a = b. On a small torus, it
// is also so if a film ends at the junction at which it begins, or has the same bubble on both
// sides. The block is then on the diagonal of the Hessian, and only its lower triangle is added.
template <class Matrix>
void add_block(double* values,
               int stride,
               const Matrix& film,
               std::array<std::size_t, 2> pair,
               bool is_on_diagonal) {
    const auto [a, b] = pair;
    for (int column = 0; column < kFilmRows[b]; ++column) {
        for (int row = is_on_diagonal ? column : 0; row < kFilmRows[a]; ++row) {
            values[row] += film(kFirstFilmRow[a] + row, kFirstFilmRow[b] + column);
        }
        values += stride;
    }
}

void append_rows(int begin, int end, std::vector<int>& rows) {
    for (int row = begin; row < end; ++row) {
        rows.push_back(row);
    }
}

}  // namespace

// The block pattern of the matrix. It lists the later nodes of each node: the nodes of a larger
// index to which a film couples it. Each later node is listed once, in increasing order.
struct Hessian::NodePattern {
    // Start of each node's range in `later_nodes`; the last element is the end of the last range.
    std::vector<int> begins;
    std::vector<int> later_nodes;

    NodePattern(std::size_t node_count, std::span<const FilmNodes> films) {
        std::vector<int> bounds(node_count + 1, 0);
        for_each_pair(films, [&](int node, int) { ++bounds[static_cast<std::size_t>(node) + 1]; });
        for (std::size_t node = 0; node < node_count; ++node) {
            bounds[node + 1] += bounds[node];
        }
        std::vector<int> all(static_cast<std::size_t>(bounds.back()));
        std::vector<int> next = bounds;
        for_each_pair(films, [&](int node, int other) {
            all[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = other;
        });
        keep_each_once(all, bounds);
    }

    std::span<const int> later_nodes_of(int node) const {
        const auto k = static_cast<std::size_t>(node);
        return std::span(later_nodes)
            .subspan(static_cast<std::size_t>(begins[k]),
                     static_cast<std::size_t>(begins[k + 1] - begins[k]));
    }

  private:
    // kPairs contains the pairs of different positions in FilmNodes. The first kInnerPairs of them
    // do not contain the half angle, which is at position 4.
    static constexpr std::size_t kInnerPairs = 6;
    static constexpr std::array<std::array<std::size_t, 2>, 10> kPairs = {
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

    template <class Visit>
    static void for_each_pair(std::span<const FilmNodes> films, Visit visit) {
        for (const FilmNodes& nodes : films) {
            const std::size_t pairs = nodes.back() < 0 ? kInnerPairs : kPairs.size();
            for (const auto& [a, b] : std::span(kPairs).first(pairs)) {
                const auto [earlier, later] = std::minmax(nodes[a], nodes[b]);
                if (earlier >= 0 && earlier != later) {
                    visit(earlier, later);
                }
            }
        }
    }

    void keep_each_once(std::vector<int>& all, const std::vector<int>& bounds) {
        later_nodes.reserve(all.size());
        begins.reserve(bounds.size());
        begins.push_back(0);
        for (std::size_t node = 0; node + 1 < bounds.size(); ++node) {
            const auto begin = all.begin() + bounds[node];
            const auto end = all.begin() + bounds[node + 1];
            std::sort(begin, end);
            later_nodes.insert(later_nodes.end(), begin, std::unique(begin, end));
            begins.push_back(static_cast<int>(later_nodes.size()));
        }
    }
};

Hessian::FilmNodes Hessian::nodes_of(const Network& network, FilmId film) const {
    const HalfEdgeId h = forward_side(film);
    const auto bubble_node = [&](BubbleId bubble) {
        const int rank = unknowns_.bubble_rank[bubble];
        return rank < 0 ? -1 : junctions_ + rank;
    };
    return {unknowns_.junction_rank[network.tail(h)],
            unknowns_.junction_rank[network.head(h)],
            bubble_node(network.left(h)),
            bubble_node(network.right(h)),
            network.is_outer(film) ? unknowns_.angle_row(film) - junctions_ : -1};
}

Hessian::Hessian(const Network& network, const Unknowns& unknowns)
    : unknowns_(unknowns),
      junctions_(static_cast<int>(unknowns.junctions.size())),
      matrix_(unknowns.size(), unknowns.size()) {
    std::vector<FilmNodes> films;
    films.reserve(unknowns.films.size());
    for (const FilmId film : unknowns.films) {
        films.push_back(nodes_of(network, film));
    }
    const NodePattern pattern(
        unknowns.junctions.size() + unknowns.bubbles.size() + unknowns.outer_films.size(), films);
    fill_pattern(pattern);
    slots_.reserve(films.size());
    for (const FilmNodes& nodes : films) {
        slots_.push_back(slots_of(pattern, nodes));
    }
}

// Fills the sparsity pattern column by column. A column of a node first has the node's own rows,
// from the diagonal down. The rows of the later nodes that are coupled to the node follow.
void Hessian::fill_pattern(const NodePattern& pattern) {
    const auto node_count = static_cast<int>(pattern.begins.size()) - 1;
    std::vector<int> rows;
    int* ends = matrix_.outerIndexPtr();
    for (int node = 0; node < node_count; ++node) {
        const int end = first_row_of(node) + rows_of(node);
        for (int column = first_row_of(node); column < end; ++column) {
            append_rows(column, end, rows);
            for (const int other : pattern.later_nodes_of(node)) {
                append_rows(first_row_of(other), first_row_of(other) + rows_of(other), rows);
            }
            *++ends = static_cast<int>(rows.size());
        }
    }
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
}

Hessian::FilmSlots Hessian::slots_of(const NodePattern& pattern, const FilmNodes& nodes) const {
    FilmSlots slots{};
    slots.blocks.fill(-1);
    for (std::size_t b = 0; b < kMaxNodes; ++b) {
        if (nodes[b] < 0) {
            continue;
        }
        const int* column = matrix_.outerIndexPtr() + first_row_of(nodes[b]);
        // The second column of a node of two rows begins one row lower than the first column.
        slots.strides[b] = column[1] - column[0] - 1;
        for (std::size_t a = 0; a < kMaxNodes; ++a) {
            if (nodes[a] >= nodes[b]) {
                slots.blocks[kMaxNodes * b + a] =
                    column[0] + rows_before(pattern, nodes[b], nodes[a]);
            }
        }
    }
    return slots;
}

// Returns the number of entries in the first column of `node` above the rows of `later_node`.
int Hessian::rows_before(const NodePattern& pattern, int node, int later_node) const {
    if (node == later_node) {
        return 0;
    }
    int rows = rows_of(node);
    for (const int* other = pattern.later_nodes_of(node).data(); *other != later_node; ++other) {
        rows += rows_of(*other);
    }
    return rows;
}

template <int Rows>
void Hessian::add_film(const FilmSlots& slots, const Eigen::Matrix<double, Rows, Rows>& film) {
    constexpr std::size_t kNodes = Rows - 2;  // tail and head have two rows each
    for (std::size_t b = 0; b < kNodes; ++b) {
        for (std::size_t a = 0; a < kNodes; ++a) {
            const int block = slots.blocks[kMaxNodes * b + a];
            if (block < 0) {
                continue;
            }
            const bool is_on_diagonal = block == slots.blocks[(kMaxNodes + 1) * b];
            add_block(matrix_.valuePtr() + block, slots.strides[b], film, {a, b}, is_on_diagonal);
        }
    }
}

void Hessian::add_outer_film(const FilmSlots& slots, const Foam& foam, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    const FilmArc arc = film_arc(foam, h);
    const double delta = pressure_difference(foam, h);
    add_film(
        slots,
        outer_film_matrix(arc.chord, delta, bulge_energy_hessian(arc, delta, foam.film_tension)));
}

const Eigen::SparseMatrix<double>& Hessian::evaluate(const Foam& foam, int threads) {
    std::vector<FilmEnergyHessian> films(slots_.size());
    parallel_for(films.size(), kFilmsPerChunk, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const HalfEdgeId h = forward_side(unknowns_.films[k]);
            if (!foam.network.is_outer(unknowns_.films[k])) {
                films[k] = film_energy_hessian(
                    chord(foam, h), pressure_difference(foam, h), foam.film_tension);
            }
        }
    });
    double* values = matrix_.valuePtr();
    std::fill(values, values + matrix_.nonZeros(), 0.0);
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        if (foam.network.is_outer(unknowns_.films[k])) {
            add_outer_film(slots_[k], foam, unknowns_.films[k]);
            continue;
        }
        const HalfEdgeId h = forward_side(unknowns_.films[k]);
        add_film(slots_[k], film_matrix(chord(foam, h), pressure_difference(foam, h), films[k]));
    }
    return matrix_;
}

}  // namespace foam
