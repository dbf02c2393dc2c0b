// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/random.h"

#include <string>

namespace foam::stress {

/// Ways to make a foam in equilibrium locally ill-defined.
enum class Damage {
    PartlyPerturbed,  // a third of the junctions moved by up to half the mean film length: tangles
    Perturbed,        // every junction moved by up to the mean film length
    Pressures,        // pressures so far off that |s| >= 1 on many films (E1)
    ZeroFilms,        // a tenth of the films without length
    Coincident,       // every junction of a bubble in one point, for a tenth of the bubbles
    Inverted,         // a tenth of the bubbles mirrored in a line through their middle
    All,              // except PartlyPerturbed
};

inline constexpr int kDamages = 7;

/// A damage in words.
const char* name_of(Damage damage);

/// Damages the foam; its network, its targets and its torus stay.
void apply(Damage damage, Foam& foam, Random& random);

/// How bad a state is.
struct IllDefined {
    int films_at_limit = 0;     // |s| above kLargestSine: most of them have no arc (E1)
    int zero_films = 0;         // of no length
    int tangled_junctions = 0;  // as is_tangled says (untangle.h)
    int inverted_bubbles = 0;   // of negative area within the chords
};

IllDefined count_ill_defined(const Foam& foam);

/// The counts in words.
std::string describe(const IllDefined& counts);

}  // namespace foam::stress
