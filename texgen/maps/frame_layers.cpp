// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/frame_layers.h"

#include "texgen/maps/arcs_of_films.h"
#include "texgen/raster/distance/distance.h"

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the value of a key in `values`. If there is none yet, adds the result of make().
template <class Key, class Value, class Make>
const Value& found_or_made(std::map<Key, Value>& values, const Key& key, const Make& make) {
    const auto found = values.find(key);
    return found != values.end() ? found->second : values.emplace(key, make()).first->second;
}

}  // namespace

FrameLayers::FrameLayers(const FrameInput& input, const RasterGrid& grid, int threads)
    : input_(input), grid_(grid), threads_(threads) {}

const Frame& FrameLayers::next() const {
    if (input_.next == nullptr) {
        throw std::invalid_argument(
            "this map shows the change to the next frame, but no next frame was given");
    }
    return *input_.next;
}

const DistanceField& FrameLayers::distance() {
    if (!distance_ && input_.fade != nullptr) {
        join_fields();
    } else if (!distance_) {
        write_distance_field(frame(), grid_, input_.distance, threads_, distance_.emplace());
    }
    return *distance_;
}

const FadeBorder* FrameLayers::border() {
    if (input_.fade == nullptr) {
        return nullptr;
    }
    distance();
    return &*border_;
}

// The border depends on the smooth distances from the films of both foams.
void FrameLayers::join_fields() {
    const CrossFade& fade = *input_.fade;
    DistanceNeeds needs = input_.distance;
    needs.smooth = SmoothImages::DistanceAndGradient;
    DistanceField out = distance_field(fade.fading_out, grid_, needs, threads_);
    DistanceField in = distance_field(fade.fading_in, grid_, needs, threads_);
    border_ = join_at_border(fade, grid_, threads_, out, in);
    distance_ = &frame() == &fade.fading_in ? std::move(in) : std::move(out);
}

FrameLayers FrameLayers::on_grid(const RasterGrid& grid, const DistanceNeeds& distance) const {
    FrameInput input = input_;
    input.next = nullptr;
    input.distance = distance;
    return {input, grid, threads_};
}

const CellArcs& FrameLayers::arcs(double film_width) {
    return found_or_made(
        arcs_, film_width, [&] { return cell_arcs(frame(), grid_, film_width, threads_); });
}

const Grain& FrameLayers::grain(const GrainRule& rule) {
    const bool has_slopes =
        rule.use == GrainUse::Relief && input_.distance.smooth == SmoothImages::DistanceAndGradient;
    return found_or_made(grains_, rule, [&] {
        return draw_grain(frame(),
                          grid_,
                          distance().ids,
                          rule,
                          has_slopes ? GrainImages::ValuesAndSlopes : GrainImages::Values,
                          threads_);
    });
}

const Maze& FrameLayers::maze(const MazeRule& rule) {
    return found_or_made(mazes_, rule, [&] { return find_maze(frame(), rule); });
}

const ArcDistances& FrameLayers::wall_distances(const MazeRule& rule,
                                                const ArcDistanceNeeds& needs) {
    return found_or_made(wall_distances_, std::pair(rule, needs), [&] {
        const Maze& with_walls = maze(rule);
        const std::vector<PlacedArc> walls = arcs_of_films(
            frame(), grid_, threads_, [&](FilmId film) { return with_walls.is_open[film] == 0; });
        return distances_to_arcs(walls, grid_, frame().domain, needs, threads_);
    });
}

}  // namespace foam::texgen
