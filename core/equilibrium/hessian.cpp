#include "core/equilibrium/hessian.h"

#include "core/geometry/film_energy.h"

#include <algorithm>

namespace foam {

namespace {

using FilmMatrix = Eigen::Matrix<double, 6, 6>;

// Second derivatives of one film's part of L by (tail, head, left pressure, right pressure).
FilmMatrix film_matrix(const Vec2& d, double delta, double tension) {
    const FilmEnergyHessian hessian = film_energy_hessian(d, delta, tension);
    Mat2 turn_right;
    turn_right << 0.0, 1.0, -1.0, 0.0;
    const Mat2 polygon = -0.5 * delta * turn_right;
    const Vec2 push = -0.5 * turn_right * d;  // of both ends, per unit of delta
    FilmMatrix m = FilmMatrix::Zero();
    m.block<2, 2>(0, 0) = hessian.chord_chord;
    m.block<2, 2>(2, 2) = hessian.chord_chord;
    m.block<2, 2>(0, 2) = polygon - hessian.chord_chord;
    m.block<2, 2>(2, 0) = m.block<2, 2>(0, 2).transpose();
    m.block<2, 1>(0, 4) = push - hessian.chord_pressure;
    m.block<2, 1>(2, 4) = push + hessian.chord_pressure;
    m.block<4, 1>(0, 5) = -m.block<4, 1>(0, 4);
    m.block<2, 4>(4, 0) = m.block<4, 2>(0, 4).transpose();
    m(4, 4) = m(5, 5) = hessian.pressure_pressure;
    m(4, 5) = m(5, 4) = -hessian.pressure_pressure;
    return m;
}

void add_lower_entries(const std::array<int, 6>& rows,
                       std::vector<Eigen::Triplet<double>>& entries) {
    for (const int column : rows) {
        for (const int row : rows) {
            if (row >= column) {
                entries.emplace_back(row, column, 0.0);
            }
        }
    }
}

}  // namespace

Hessian::FilmRows Hessian::rows_of(const Network& network, FilmId film) const {
    const HalfEdgeId h = forward_side(film);
    const int tail = unknowns_.position_row(network.tail(h));
    const int head = unknowns_.position_row(network.head(h));
    return {tail,
            tail + 1,
            head,
            head + 1,
            unknowns_.pressure_row(network.left(h)),
            unknowns_.pressure_row(network.right(h))};
}

Hessian::Hessian(const Network& network, const Unknowns& unknowns)
    : unknowns_(unknowns), matrix_(unknowns.size(), unknowns.size()) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * unknowns.films.size());
    for (const FilmId film : unknowns.films) {
        add_lower_entries(rows_of(network, film), entries);
    }
    matrix_.setFromTriplets(entries.begin(), entries.end());
    slots_.reserve(unknowns.films.size());
    for (const FilmId film : unknowns.films) {
        slots_.push_back(slots_of(rows_of(network, film)));
    }
}

Hessian::FilmSlots Hessian::slots_of(const FilmRows& rows) const {
    FilmSlots slots;
    for (std::size_t b = 0; b < 6; ++b) {
        const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[rows[b]];
        const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[rows[b] + 1];
        for (std::size_t a = 0; a < 6; ++a) {
            const int* found = std::lower_bound(begin, end, rows[a]);
            slots[6 * b + a] =
                rows[a] < rows[b] ? -1 : static_cast<int>(found - matrix_.innerIndexPtr());
        }
    }
    return slots;
}

const Eigen::SparseMatrix<double>& Hessian::evaluate(const Foam& foam) {
    double* values = matrix_.valuePtr();
    std::fill(values, values + matrix_.nonZeros(), 0.0);
    for (std::size_t k = 0; k < unknowns_.films.size(); ++k) {
        const HalfEdgeId h = forward_side(unknowns_.films[k]);
        const FilmMatrix m =
            film_matrix(chord(foam, h), pressure_difference(foam, h), foam.film_tension);
        for (std::size_t entry = 0; entry < 36; ++entry) {
            if (slots_[k][entry] >= 0) {
                values[slots_[k][entry]] += m.data()[entry];
            }
        }
    }
    return matrix_;
}

}  // namespace foam
