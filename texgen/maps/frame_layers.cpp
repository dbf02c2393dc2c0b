// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/frame_layers.h"

#include "texgen/raster/distance/distance.h"

#include <stdexcept>

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
    if (!distance_) {
        write_distance_field(frame(), grid_, input_.distance, threads_, distance_.emplace());
    }
    return *distance_;
}

const CellArcs& FrameLayers::arcs(double film_width) {
    const auto known = arcs_.find(film_width);
    if (known != arcs_.end()) {
        return known->second;
    }
    return arcs_.emplace(film_width, cell_arcs(frame(), grid_, film_width, threads_)).first->second;
}

}  // namespace foam::texgen
