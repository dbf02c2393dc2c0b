// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/record.h"

#include "texgen/maps/all_maps.h"

#include <numbers>
#include <utility>

namespace foam::texgen {

double RunRecord::law_rate(int sides) const {
    return std::numbers::pi / 3.0 * film_tension * kappa * (sides - 6);
}

Recorder::Recorder(const Preset& preset)
    : run_{preset.name, 2.0 * preset.seeding.surface_tension, preset.coarsening.kappa, {}} {
    if (shows_maze(preset.image.maps, preset.maps)) {
        maze_ = maze_rule(preset.maps.maze);
    }
}

void Recorder::record(const std::shared_ptr<const Frame>& frame, const FrameEffort& effort) {
    FrameRecord record{frame->number, frame->time, statistics(*frame), {}, effort};
    if (before_) {
        record.growth = growth_by_sides(*before_, *frame);
    }
    if (maze_) {
        record.maze = measure(find_maze(*frame, *maze_), *frame);
    }
    run_.frames.push_back(std::move(record));
    before_ = frame;
}

FrameVisitor Recorder::visitor() {
    return [this](const SimulatedFrame& shown) { record(shown.frame, shown.effort); };
}

}  // namespace foam::texgen
