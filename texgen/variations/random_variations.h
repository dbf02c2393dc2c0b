// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"
#include "texgen/variations/variation.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {

/// The options of random_variations.
struct RandomDraw {
    int count = 12;
    std::uint64_t seed = 1;            // seed of the random numbers that choose the values
    std::set<std::string> fixed = {};  // keys that do not vary
};

/// The largest value of foam.seed in a random variation if preset.vary does not list foam.seed.
inline constexpr int kMaxRandomSeed = 999;

/// Returns variations with random values of foam.seed and of the keys in preset.vary, each value
/// independent of the others. All values of a list and, before rounding (number_at), all numbers of
/// a range are equally likely. The first variations are the same for any `count`, and the values of
/// the keys that vary are the same for any `fixed`. Throws PresetError if preset.vary is empty, or
/// if no key varies.
std::vector<Variation> random_variations(const Preset& preset, const RandomDraw& draw);

}  // namespace foam::texgen
