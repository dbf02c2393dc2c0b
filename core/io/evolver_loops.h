#pragma once

#include "core/io/evolver_mesh.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// A film as one of its two faces meets it: edges in a row, from junction to junction. Vertices
/// between them join two edges only.
struct FilmSide {
    EdgeSide first;
    EdgeSide last;
    std::size_t tail = 0;  // a place in Mesh::vertices
    LatticeOffset offset;  // the head's copy, for the vertices where the file has them
};

/// The films around a face, counter-clockwise.
struct FilmLoop {
    std::vector<FilmSide> films;
    double polygon_area = 0.0;  // within its straight edges
};

/// The faces of a mesh on a torus or in the plane, in their order, as loops of films. Where the
/// file gives no edge a wrap, each edge goes to the nearest copy of its head. Throws FormatError,
/// in the name of `file`, where they do not cover the torus once, a film has no face on a side (in
/// the plane, on both), or a vertex joins other than three films.
std::vector<FilmLoop> film_loops(const Mesh& mesh, const Domain& domain, const std::string& file);

}  // namespace foam::evolver
