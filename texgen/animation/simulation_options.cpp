// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulation_options.h"

#include "core/equilibrium/newton_system.h"

#include <array>
#include <memory>

namespace foam::texgen {

CycleOptions cycle_options_of(const Preset& preset) {
    const LoopOptions& loop = preset.loop;
    CycleOptions options{.steps = preset.frames.count, .seed = preset.seeding.seed};
    (loop.kind == LoopKind::Shear ? options.strain : options.area_amplitude) = loop.amplitude;
    options.boiling = loop.kind == LoopKind::Boil ? loop.boiling : 0.0;
    options.boiling_rise = loop.rise;
    return options;
}

int usual_cycles(int bubbles) {
    struct Measured {
        int bubbles;
        int cycles;
    };
    constexpr std::array<Measured, 5> kMeasured{
        {{100, 18}, {300, 30}, {500, 28}, {1000, 34}, {2000, 38}}};
    for (const Measured& measured : kMeasured) {
        if (bubbles <= measured.bubbles) {
            return measured.cycles;
        }
    }
    return kMeasured.back().cycles;
}

StepOptions step_options_of(const Preset& preset, int threads) {
    StepOptions options;
    options.coarsening = preset.coarsening;
    options.solver = preset.equilibrium.solver;
    options.equilibrium.tolerance = preset.equilibrium.tolerance;
    options.equilibrium.thresholds = preset.thresholds;
    options.equilibrium.threads = threads;
    options.equilibrium.system = std::make_shared<NewtonSystem>();
    return options;
}

}  // namespace foam::texgen
