#include "texgen/raster/film_shapes.h"

#include "texgen/raster/half_turns.h"
#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

namespace {

constexpr std::size_t kPerTask = 64 * HalfTurns::kLanes;

}  // namespace

std::vector<PixelArc> film_shapes(const Frame& frame, double scale, int threads) {
    const std::size_t count = frame.network.film_slots();
    std::vector<PixelArc> shapes(count);
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
            shapes[first + lane] = {
                scale * arc_of(first + lane).chord, turns.cosine[lane], turns.sine[lane]};
        }
    };
    const std::size_t tasks = (count + kPerTask - 1) / kPerTask;
    parallel_for(static_cast<int>(tasks), threads, [&](int task) {
        const std::size_t begin = static_cast<std::size_t>(task) * kPerTask;
        for (std::size_t k = begin; k < std::min(begin + kPerTask, count); k += HalfTurns::kLanes) {
            shape_some(k);
        }
    });
    return shapes;
}

}  // namespace foam::texgen
