// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/film_arcs.h"

#include "texgen/raster/simd/kernel.h"

namespace foam::texgen {

namespace {

// Returns 1 - z a (1 - z b (1 - z c ...)) for factors a, b, c, ...
template <class... Later>
inline double nested(double z, double factor, Later... later) {
    if constexpr (sizeof...(later) == 0) {
        return 1.0 - z * factor;
    } else {
        return 1.0 - z * (factor * nested(z, later...));
    }
}

// Return sin(h) / h and cos(h), from power series in z = h². The errors are up to 4e-15 for |h| up
// to 90 degrees. Each factor is the ratio of two successive coefficients, for example 3! / 5!.
inline double sine_series(double z) {
    return nested(z,
                  1.0 / 6.0,
                  1.0 / 20.0,
                  1.0 / 42.0,
                  1.0 / 72.0,
                  1.0 / 110.0,
                  1.0 / 156.0,
                  1.0 / 210.0,
                  1.0 / 272.0,
                  1.0 / 342.0);
}

inline double cosine_series(double z) {
    return nested(z,
                  1.0 / 2.0,
                  1.0 / 12.0,
                  1.0 / 30.0,
                  1.0 / 56.0,
                  1.0 / 90.0,
                  1.0 / 132.0,
                  1.0 / 182.0,
                  1.0 / 240.0,
                  1.0 / 306.0);
}

}  // namespace

// Uses the double-angle formulas cos a = 1 - 2 sin²(a / 2) and sin a = 2 sin(a / 2) cos(a / 2), so
// that the series are evaluated only up to 90 degrees.
void find_sines_and_cosines(HalfAngles& half_angles) {
    at_simd_level([&half_angles] {
        for (std::size_t k = 0; k < HalfAngles::kLanes; ++k) {
            const double half = 0.5 * half_angles.angle[k];
            const double square = half * half;
            const double sine = half * sine_series(square);
            half_angles.sine[k] = 2.0 * sine * cosine_series(square);
            half_angles.cosine[k] = 1.0 - 2.0 * sine * sine;
        }
    });
}

std::vector<PixelArc> film_arcs(const Frame& frame, double scale, int threads) {
    std::vector<PixelArc> arcs(frame.network.film_slots());
    for_each_film_arc(
        frame, scale, threads, [&](std::size_t film, const PixelArc& arc) { arcs[film] = arc; });
    return arcs;
}

}  // namespace foam::texgen
