// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/evolver_mesh.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// One side of a film: the chain of edges of a face from one junction to the next. Each vertex
/// between two edges of the chain joins only these two edges.
struct FilmSide {
    EdgeSide first;        // first edge of the chain
    EdgeSide last;         // last edge of the chain
    std::size_t tail = 0;  // index in Mesh::vertices
    LatticeOffset offset;  // lattice offset of the copy of the head at which the film ends
};

/// The films around a face, counter-clockwise.
struct FilmLoop {
    std::vector<FilmSide> films;
    double polygon_area = 0.0;  // area within the straight edges of the face
};

/// Returns the faces of a mesh on a torus or in the plane as loops of films, in the order of
/// Mesh::faces. The lattice offsets of the films refer to reduced_lattice(domain)
/// (core/foam/lattice.h). The wrap of an edge is the lattice offset that the file gives for its
/// head. If no edge of the file has a wrap, each edge ends at the copy of its head that is nearest
/// to its tail. On a sheared torus, the nearest row of copies is chosen first, and then the nearest
/// copy in this row. If some edges have a wrap, the wrap of all other edges is zero. In the plane,
/// wraps are ignored. Throws FormatError, with `file` as the name in its message, in these cases:
/// - the faces do not cover the torus once;
/// - an edge has two faces on one side;
/// - an edge has no face on one side (in the plane: on both sides);
/// - a vertex joins one edge or more than three;
/// - a face is not a closed loop, or has no vertex of three edges;
/// - the edges of a face lead more than kMaxPeriods periods away from its first vertex
///   (core/network/validate.h);
/// - a vertex is more than a million periods from the origin of a torus.
std::vector<FilmLoop> film_loops(const Mesh& mesh, const Domain& domain, const std::string& file);

}  // namespace foam::evolver
