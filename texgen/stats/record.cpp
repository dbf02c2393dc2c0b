// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/record.h"

#include "core/dynamics/shear_modulus.h"
#include "texgen/maps/all_maps.h"

#include <numbers>
#include <utility>

namespace foam::texgen {

double RunRecord::law_rate(int sides) const {
    return std::numbers::pi / 3.0 * film_tension * kappa * (sides - 6);
}

Recorder::Recorder(const Preset& preset, int threads)
    : run_{preset.name, 2.0 * preset.seeding.surface_tension, preset.coarsening.kappa, {}},
      threads_(threads) {
    if (shows_maze(preset.image.maps, preset.maps)) {
        maze_ = maze_rule(preset.maps.maze);
    }
}

void Recorder::record(const std::shared_ptr<const Frame>& frame, const FrameEffort& effort) {
    FrameRecord record{frame->number, frame->time, statistics(*frame), {}, effort};
    if (run_.last_frame) {
        record.growth = growth_by_sides(*run_.last_frame, *frame);
    }
    if (maze_) {
        record.maze = measure(find_maze(*frame, *maze_), *frame);
    }
    record.shear_modulus = shear_modulus(*frame, threads_);
    run_.frames.push_back(std::move(record));
    run_.last_frame = frame;
}

FrameVisitor Recorder::visitor() {
    return [this](const SimulatedFrame& shown) { record(shown.frame, shown.effort); };
}

}  // namespace foam::texgen
