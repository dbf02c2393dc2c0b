// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/frame_layers.h"

#include "texgen/maps/arcs_of_films.h"
#include "texgen/raster/distance/distance.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace foam::texgen {

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
    needs.smooth = true;
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
    const auto known = arcs_.find(film_width);
    if (known != arcs_.end()) {
        return known->second;
    }
    return arcs_.emplace(film_width, cell_arcs(frame(), grid_, film_width, threads_)).first->second;
}

const Grain& FrameLayers::grain(const GrainRule& rule) {
    const auto known = grains_.find(rule);
    if (known != grains_.end()) {
        return known->second;
    }
    Grain grain = draw_grain(frame(), grid_, distance().ids, rule, threads_);
    return grains_.emplace(rule, std::move(grain)).first->second;
}

const Maze& FrameLayers::maze(const MazeRule& rule) {
    const auto known = mazes_.find(rule);
    return known != mazes_.end() ? known->second
                                 : mazes_.emplace(rule, find_maze(frame(), rule)).first->second;
}

const ArcDistances& FrameLayers::wall_distances(const MazeRule& rule,
                                                const ArcDistanceNeeds& needs) {
    const auto known = wall_distances_.find({rule, needs});
    if (known != wall_distances_.end()) {
        return known->second;
    }
    const Maze& with_walls = maze(rule);
    const std::vector<PlacedArc> walls = arcs_of_films(
        frame(), grid_, threads_, [&](FilmId film) { return with_walls.is_open[film] == 0; });
    ArcDistances distances = distances_to_arcs(walls, grid_, frame().domain, needs, threads_);
    return wall_distances_.emplace(std::pair(rule, needs), std::move(distances)).first->second;
}

}  // namespace foam::texgen
