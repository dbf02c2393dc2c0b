#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam {

/// A foam from another program, in its own units of length and energy.
struct EvolverFoam {
    Foam foam;
    std::vector<std::string> notes;  // what of the file a foam has not, one line each
};

/// Reads a Surface Evolver data file or dump: a two-dimensional string model on a torus, or a free
/// cluster, its edges straight or arcs. Bubbles are the faces, films the edges (with vertices of
/// two edges dissolved) and junctions the vertices of three, all in the order of the file. Target
/// areas are the bodies' volumes, pressures their Lagrange multipliers, 0 where there are none.
/// README.md says what is taken, passed over and refused. Throws FormatError in the name of `file`.
EvolverFoam read_evolver(std::string_view text, const std::string& file);

/// How films are written.
enum class EvolverEdges {
    Arcs,      // exact: circular arcs through a midpoint, in the quadratic model
    Straight,  // the linear model
};

/// The foam as a Surface Evolver data file, numbered from 1 in the order of the live ids. Pressures
/// of a torus are shifted to 0 in the first body, as Evolver has them; all other numbers read back
/// to the same bits. The time, the identities, the armed films and lone bubbles are left out.
std::string write_evolver(const Foam& foam, EvolverEdges edges = EvolverEdges::Arcs);

}  // namespace foam
