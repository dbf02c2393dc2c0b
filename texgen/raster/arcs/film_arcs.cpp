// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/film_arcs.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// Returns sin(h) / h if N is 2, or cos(h) if N is 1, from a power series in z = h². Each level of
// the recursion adds a term. Its coefficient is the coefficient of the term before it, divided by
// -N (N + 1) with the N of the level. The error is up to 4e-15 for |h| up to 90 degrees.
template <int N>
double series(double z) {
    if constexpr (N > 18) {
        return 1.0;
    } else {
        return 1.0 - z * (1.0 / (N * (N + 1)) * series<N + 2>(z));
    }
}

}  // namespace

// The angles a are up to 180 degrees. The series are evaluated at a / 2, which is at most 90
// degrees. The results follow from cos a = 1 - 2 sin²(a / 2) and sin a = 2 sin(a / 2) cos(a / 2).
void find_sines_and_cosines(HalfAngles& half_angles) {
    at_simd_level([&half_angles] {
        for (std::size_t k = 0; k < HalfAngles::kLanes; ++k) {
            const double half = 0.5 * half_angles.angle[k];
            const double square = half * half;
            const double sine = half * series<2>(square);
            half_angles.sine[k] = 2.0 * sine * series<1>(square);
            half_angles.cosine[k] = 1.0 - 2.0 * sine * sine;
        }
    });
}

// Computes the arcs in groups of HalfAngles::kLanes films.
std::vector<PixelArc> film_arcs(const Frame& frame, double scale, int threads) {
    constexpr std::size_t kPerTask = 64 * HalfAngles::kLanes;
    const auto arc_of = [&](std::size_t film) -> const FilmArc& {
        return frame.arcs[id_at<FilmId>(film)];
    };
    std::vector<PixelArc> arcs(frame.network.film_slots());
    parallel_for(arcs.size(), kPerTask, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t first = begin; first < end; first += HalfAngles::kLanes) {
            const std::size_t count = std::min(HalfAngles::kLanes, end - first);
            HalfAngles half_angles;
            for (std::size_t k = 0; k < count; ++k) {
                half_angles.angle[k] = arc_of(first + k).half_angle;
            }
            find_sines_and_cosines(half_angles);
            for (std::size_t k = 0; k < count; ++k) {
                arcs[first + k] = {
                    scale * arc_of(first + k).chord, half_angles.cosine[k], half_angles.sine[k]};
            }
        }
    });
    return arcs;
}

}  // namespace foam::texgen
