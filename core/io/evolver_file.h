// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam {

/// A foam from another program, in its own units of length and energy.
struct EvolverFoam {
    Foam foam;
    std::vector<std::string> notes;  // features of the file that were dropped, one line each
};

/// Reads a Surface Evolver data file or dump: a two-dimensional string model on a torus or a free
/// cluster, with straight edges or arcs. Bubbles are the faces, films are the edges (vertices of
/// two edges are dissolved), and junctions are the vertices of three edges, all in the order of the
/// file. Target areas are the volumes of the bodies; pressures are their Lagrange multipliers, or 0
/// for bodies without one. README.md lists what is read, ignored and rejected. Throws FormatError,
/// with `file` as the name in its message, if the file is not valid or not supported.
EvolverFoam read_evolver(std::string_view text, const std::string& file);

/// How write_evolver writes films.
enum class EvolverEdges {
    Arcs,      // exact: circular arcs through a midpoint, in the quadratic model
    Straight,  // the linear model
};

/// Returns the foam as the text of a Surface Evolver data file. Elements are numbered from 1 in the
/// order of the live ids. The pressures of a torus are shifted so that the first body has 0, which
/// is Evolver's convention; all other numbers read back to the same bits. The time, the identities,
/// the armed flags of films, and lone bubbles are not written.
std::string write_evolver(const Foam& foam, EvolverEdges edges = EvolverEdges::Arcs);

}  // namespace foam
