// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "core/parallel/parallel_for.h"
#include "texgen/raster/arcs/pixel_arc.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Angles in [-pi, pi] with their cosines and sines. These are computed by IEEE operations alone,
/// so that they are the same on every machine, with errors of up to 1e-14.
struct HalfAngles {
    static constexpr std::size_t kLanes = 8;

    std::array<double, kLanes> angle{};
    std::array<double, kLanes> cosine{};
    std::array<double, kLanes> sine{};
};

/// Computes the cosines and sines of all lanes.
void find_sines_and_cosines(HalfAngles& turns);

/// The number of films whose shapes are computed at once.
inline constexpr std::size_t kFilmsPerGroup = HalfAngles::kLanes;

/// Calls take(index, arc) for up to kFilmsPerGroup films from index `first` on. `arc` is the arc of
/// the forward side in pixels; `scale` is in pixels per foam unit.
template <class Take>
void shape_some(const Frame& frame, double scale, std::size_t first, const Take& take) {
    const std::size_t count = std::min(kFilmsPerGroup, frame.network.film_slots() - first);
    const auto arc_of = [&](std::size_t lane) -> const FilmArc& {
        return frame.arcs[id_at<FilmId>(first + lane)];
    };
    HalfAngles turns;
    for (std::size_t lane = 0; lane < count; ++lane) {
        turns.angle[lane] = arc_of(lane).half_angle;
    }
    find_sines_and_cosines(turns);
    for (std::size_t lane = 0; lane < count; ++lane) {
        take(first + lane,
             PixelArc{scale * arc_of(lane).chord, turns.cosine[lane], turns.sine[lane]});
    }
}

/// Calls take(index, arc) for all films, on several threads and in no particular order.
template <class Take>
void shape_films(const Frame& frame, double scale, int threads, const Take& take) {
    constexpr std::size_t kPerTask = 64 * kFilmsPerGroup;
    const std::size_t count = frame.network.film_slots();
    parallel_for(count, kPerTask, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; k += kFilmsPerGroup) {
            shape_some(frame, scale, k, take);
        }
    });
}

/// Returns the arcs of the forward sides of all films, in pixels, by the index of the film. `scale`
/// is in pixels per foam unit.
std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads);

/// Returns the arc of a side. There is no branch on the direction of the side, which would be
/// unpredictable.
inline PixelArc shape_along(std::span<const PixelArc> shapes, HalfEdgeId side) {
    const PixelArc& forward = shapes[index_of(film_of(side))];
    const double along = static_cast<int>(is_forward(side)) * 2 - 1;
    return {along * forward.chord, forward.cosine, along * forward.sine};
}

}  // namespace foam::texgen
