#pragma once

#include "core/geometry/domain.h"
#include "core/io/evolver_header.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace foam::evolver {

struct Vertex {
    int id = 0;
    int line = 0;
    Vec2 point{0.0, 0.0};  // anywhere in the plane
};

struct Edge {
    int id = 0;
    int line = 0;
    std::size_t tail = 0;  // places in Mesh::vertices
    std::size_t head = 0;
    std::optional<LatticeOffset> wrap;  // the head's copy, in periods
    double tension = 1.0;
};

/// A place in Mesh::edges, and whether the edge is walked from tail to head.
struct EdgeSide {
    std::size_t edge = 0;
    bool forward = true;
};

struct Face {
    int id = 0;
    int line = 0;
    std::vector<EdgeSide> sides;
    bool has_body = false;
};

struct Body {
    int id = 0;
    int line = 0;
    std::size_t face = 0;   // a place in Mesh::faces
    bool reversed = false;  // whether it lies on the other side of the face
    std::optional<double> volume;
    std::optional<double> pressure;
};

/// The elements of a data file, each in the order of the file.
struct Mesh {
    std::vector<Vertex> vertices;  // of midpoints too
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Body> bodies;
    int held = 0;  // vertices and edges that are fixed or on a constraint, which a foam has not
    int end_line = 0;
};

/// Reads the sections of vertices, edges, faces and bodies, up to `read` or the end of the file.
/// Attributes that do not bear on a foam's equilibrium are passed over. Throws FormatError.
Mesh read_mesh(TokenReader& tokens, const Parameters& parameters);

}  // namespace foam::evolver
