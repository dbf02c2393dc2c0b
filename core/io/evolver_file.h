// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam {

/// A foam that was read from a Surface Evolver file, in the units of length and energy of that
/// file.
struct EvolverFoam {
    Foam foam;
    std::vector<std::string> notes;  // remarks for the user, one line each
};

/// Reads a Surface Evolver data file or dump. It must contain a two-dimensional string model: a
/// torus, or a free cluster in the plane. Edges are straight or arcs. Bubbles are the faces, films
/// are the edges, and junctions are the vertices of three edges, all in the order of the file.
/// Vertices of two edges are dissolved. On a torus, the magnitude of the shear is reduced to at
/// most half of the width (reduced_lattice). Target areas are the volumes of the bodies; pressures
/// are the Lagrange multipliers of the bodies, by default 0. README.md lists all elements that are
/// read, ignored or rejected. Throws FormatError, with `file` as the name in its message, if the
/// file is not valid or not supported.
EvolverFoam read_evolver(std::string_view text, const std::string& file);

/// The form in which write_evolver writes films.
enum class EvolverEdges {
    Arcs,      // exact: circular arcs through a midpoint, in the quadratic model
    Straight,  // straight edges, in the linear model
};

/// Returns the foam as the text of a Surface Evolver data file. Elements are numbered from 1 by
/// increasing id; dead slots are skipped. The pressures of a torus are shifted so that the first
/// body has the pressure 0, which is Evolver's convention. Every number is written with the fewest
/// digits that read back to the same bits. The time, the identities and the armed flags of films
/// (Foam::t1_armed) are not written. The half angles of outer films are not written either. The
/// midpoints of arcs show them, but read_evolver ignores midpoints. Throws std::range_error if the
/// foam has lone bubbles, or if a component of a lattice offset is below -16 or above 15. The
/// format cannot store such a foam.
std::string write_evolver(const Foam& foam, EvolverEdges edges = EvolverEdges::Arcs);

}  // namespace foam
