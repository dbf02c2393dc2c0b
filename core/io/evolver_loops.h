// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/evolver_mesh.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// One side of a film: a chain of edges from junction to junction along one of its two faces. The
/// vertices between the edges of a chain join two edges only.
struct FilmSide {
    EdgeSide first;
    EdgeSide last;
    std::size_t tail = 0;  // index in Mesh::vertices
    LatticeOffset offset;  // periods from the head's position in the file to the film's end
};

/// The films around a face, counter-clockwise.
struct FilmLoop {
    std::vector<FilmSide> films;
    double polygon_area = 0.0;  // area within the straight edges of the face
};

/// Returns the faces of a mesh on a torus or in the plane, in their order, as loops of films. If no
/// edge of the file has a wrap, each edge goes to the nearest copy of its head. Throws FormatError,
/// with `file` as the name in its message, if the faces do not cover the torus once, if an edge has
/// no face on one side (in the plane, on both sides), if a vertex joins one edge or more than
/// three, if a face is not a closed loop, or if it has no vertex of three edges.
std::vector<FilmLoop> film_loops(const Mesh& mesh, const Domain& domain, const std::string& file);

}  // namespace foam::evolver
