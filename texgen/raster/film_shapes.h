#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/half_turns.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/pixel_arc.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Calls take(index, arc) for all films, each as its forward side, in pixels of a scale (pixels per
/// foam unit); on up to `threads` threads, in no certain order.
template <class Take>
void shape_films(const Frame& frame, double scale, int threads, const Take& take) {
    constexpr std::size_t kPerTask = 64 * HalfTurns::kLanes;
    const std::size_t count = frame.network.film_slots();
    const auto arc_of = [&](std::size_t k) -> const FilmArc& {
        return frame.arcs[id_at<FilmId>(k)];
    };
    const auto shape_some = [&](std::size_t first) {
        const std::size_t lanes = std::min(HalfTurns::kLanes, count - first);
        HalfTurns turns;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            turns.angle[lane] = arc_of(first + lane).half_angle;
        }
        find_turns(turns);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            take(
                first + lane,
                PixelArc{scale * arc_of(first + lane).chord, turns.cosine[lane], turns.sine[lane]});
        }
    };
    const std::size_t tasks = (count + kPerTask - 1) / kPerTask;
    parallel_for(static_cast<int>(tasks), threads, [&](int task) {
        const std::size_t begin = static_cast<std::size_t>(task) * kPerTask;
        for (std::size_t k = begin; k < std::min(begin + kPerTask, count); k += HalfTurns::kLanes) {
            shape_some(k);
        }
    });
}

/// The arcs of all films.
std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads);

/// One of them as a side of its film; without a branch, as nobody foresees which way it is walked.
inline PixelArc shape_along(std::span<const PixelArc> shapes, HalfEdgeId side) {
    const PixelArc& forward = shapes[index_of(film_of(side))];
    const double along = static_cast<int>(is_forward(side)) * 2 - 1;
    return {along * forward.chord, forward.cosine, along * forward.sine};
}

}  // namespace foam::texgen
