// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation.h"

#include "texgen/preset/key_values.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <cstddef>

namespace foam::texgen {

namespace {

void check_sweeps(std::span<const Sweep> sweeps) {
    std::size_t count = 1;
    for (std::size_t k = 0; k < sweeps.size(); ++k) {
        count *= sweeps[k].values.size();
        for (std::size_t other = 0; other < k; ++other) {
            if (sweeps[other].key == sweeps[k].key) {
                throw PresetError(fmt::format("{}: {} has a sweep already",
                                              sweeps[k].values.front().location,
                                              sweeps[k].key));
            }
        }
    }
    if (count > kMaxValues) {
        throw PresetError(fmt::format(
            "the sweeps have {} combinations; at most {} are allowed", count, kMaxValues));
    }
}

}  // namespace

std::vector<Variation> variations_of(std::span<const Sweep> sweeps) {
    check_sweeps(sweeps);
    std::vector<Variation> variations(1);
    for (const Sweep& sweep : sweeps) {
        std::vector<Variation> extended;
        for (const Variation& variation : variations) {
            for (const Assignment& value : sweep.values) {
                Variation& one = extended.emplace_back(variation);
                one.assignments.push_back(value);
            }
        }
        variations = std::move(extended);
    }
    return variations;
}

std::vector<Preset> presets_of(const Preset& preset, std::span<const Variation> variations) {
    std::vector<Preset> presets;
    for (const Variation& variation : variations) {
        assign(presets.emplace_back(preset), variation.assignments);
    }
    return presets;
}

}  // namespace foam::texgen
