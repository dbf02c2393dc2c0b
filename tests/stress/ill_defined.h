// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/random.h"

#include <string>

namespace foam::stress {

/// The kinds of damage that make a foam in equilibrium locally ill-defined.
enum class Damage {
    PartlyPerturbed,  // moves a third of the junctions by up to half the mean film length
    Perturbed,        // moves every junction by up to the mean film length
    Pressures,        // changes pressures so much that |s| >= 1 on many films (E1)
    ZeroFilms,        // gives a tenth of the films zero length
    Coincident,       // moves all junctions of a bubble to one point, for a tenth of the bubbles
    Inverted,         // mirrors a tenth of the bubbles in a horizontal line
    All,              // applies all kinds except PartlyPerturbed, one after another
};

inline constexpr int kDamages = 7;

/// Returns the name of a kind of damage for reports.
const char* name_of(Damage damage);

/// Damages the foam. Its topology, target areas and domain do not change.
void apply(Damage damage, Foam& foam, Random& random);

/// The numbers of ill-defined elements of a state.
struct IllDefined {
    int films_at_limit = 0;     // films with |s| above kLargestSine; most have no arc (E1)
    int zero_films = 0;         // films of zero length
    int tangled_junctions = 0;  // junctions for which is_tangled is true (untangle.h)
    int inverted_bubbles = 0;   // bubbles whose polygon of chords has a negative area
};

/// Counts the ill-defined elements of a foam.
IllDefined count_ill_defined(const Foam& foam);

/// Returns the counts in words.
std::string describe(const IllDefined& counts);

}  // namespace foam::stress
