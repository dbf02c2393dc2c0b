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

/// Eight angles in [-pi, pi], in radians, with their cosines and sines.
struct HalfAngles {
    static constexpr std::size_t kLanes = 8;

    std::array<double, kLanes> angle{};
    std::array<double, kLanes> cosine{};
    std::array<double, kLanes> sine{};
};

/// Computes the cosine and the sine of every angle. Uses only additions, subtractions and
/// multiplications, so that the results have the same bits on every machine. The errors of the
/// results are up to 1e-14.
void find_sines_and_cosines(HalfAngles& half_angles);

/// The number of films whose arcs are computed at once.
inline constexpr std::size_t kFilmsPerGroup = HalfAngles::kLanes;

/// Calls take(index, arc) for each film of a group: the kFilmsPerGroup films from index `first` on,
/// or fewer at the end of the network. `arc` is the arc of the forward side of the film in pixels.
/// `scale` is in pixels per foam unit. Precondition: first < frame.network.film_slots().
template <class Take>
void for_each_arc_in_group(const Frame& frame, double scale, std::size_t first, const Take& take) {
    const std::size_t count = std::min(kFilmsPerGroup, frame.network.film_slots() - first);
    const auto arc_of = [&](std::size_t lane) -> const FilmArc& {
        return frame.arcs[id_at<FilmId>(first + lane)];
    };
    HalfAngles half_angles;
    for (std::size_t lane = 0; lane < count; ++lane) {
        half_angles.angle[lane] = arc_of(lane).half_angle;
    }
    find_sines_and_cosines(half_angles);
    for (std::size_t lane = 0; lane < count; ++lane) {
        take(
            first + lane,
            PixelArc{scale * arc_of(lane).chord, half_angles.cosine[lane], half_angles.sine[lane]});
    }
}

/// Calls take(index, arc) for all films, as for_each_arc_in_group does for a group. The calls are
/// made on several threads at the same time, in no particular order.
template <class Take>
void for_each_film_arc(const Frame& frame, double scale, int threads, const Take& take) {
    constexpr std::size_t kPerTask = 64 * kFilmsPerGroup;
    const std::size_t count = frame.network.film_slots();
    parallel_for(count, kPerTask, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; k += kFilmsPerGroup) {
            for_each_arc_in_group(frame, scale, k, take);
        }
    });
}

/// Returns the arcs of the forward sides of all films in pixels, indexed by film. `scale` is in
/// pixels per foam unit.
std::vector<PixelArc> film_arcs(const Frame& frame, double scale, int threads);

/// Returns the arc of a half-edge, in the direction of the half-edge. `arcs` is the result of
/// film_arcs. A factor of 1 or -1 replaces a branch on the direction, which would be unpredictable.
inline PixelArc arc_along(std::span<const PixelArc> arcs, HalfEdgeId side) {
    const PixelArc& forward = arcs[index_of(film_of(side))];
    const double along = static_cast<int>(is_forward(side)) * 2 - 1;
    return {along * forward.chord, forward.cosine, along * forward.sine};
}

}  // namespace foam::texgen
