// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/seed.h"

#include "core/foam/patch.h"
#include "texgen/preset/preset_remarks.h"

#include <fmt/core.h>

#include <stdexcept>

namespace foam::texgen {

namespace {

SeedingOptions seeding_of(const Preset& preset) {
    SeedingOptions seeding = preset.seeding;
    const DensityDomain domain = density_domain(preset);
    seeding.aspect = domain.aspect;
    seeding.areas = area_field_of(preset.density, domain);
    return seeding;
}

PatchOptions patch_options_of(const SeedingOptions& seeding) {
    return {.bubbles = seeding.bubbles,
            .lloyd_iterations = seeding.lloyd_iterations,
            .area_ratio = seeding.area_ratio,
            .surface_tension = seeding.surface_tension,
            .seed = seeding.seed,
            .areas = seeding.areas};
}

}  // namespace

Foam seeded_foam(const Preset& preset) {
    const bool is_torus = preset.shape.kind == FoamKind::Torus;
    try {
        const SeedingOptions seeding = seeding_of(preset);
        return is_torus ? seed_foam(seeding)
                        : seed_patch(outline_of(preset.shape), patch_options_of(seeding));
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(
            fmt::format("{}: cannot seed {} bubbles with foam.seed = {}: {}",
                        is_torus ? "foam.bubbles" : "foam.outline",
                        preset.seeding.bubbles,
                        preset.seeding.seed,
                        error.what()));
    }
}

}  // namespace foam::texgen
