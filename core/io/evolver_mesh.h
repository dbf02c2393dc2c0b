// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/io/evolver_header.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace foam::evolver {

/// A vertex with its number and line in the file.
struct Vertex {
    int id = 0;
    int line = 0;
    Vec2 point{0.0, 0.0};  // as in the file; may be outside of the fundamental cell
};

/// An edge with its number and line in the file.
struct Edge {
    int id = 0;
    int line = 0;
    std::size_t tail = 0;  // index in Mesh::vertices
    std::size_t head = 0;  // index in Mesh::vertices
    // The lattice offset of the copy of the head at which the edge ends; nothing if the file gives
    // no wrap for the edge.
    std::optional<LatticeOffset> wrap;
    double tension = 1.0;
};

/// An edge in one of its two directions.
struct EdgeSide {
    std::size_t edge = 0;  // index in Mesh::edges
    bool forward = true;   // true from tail to head
};

/// A face with its number and line in the file.
struct Face {
    int id = 0;
    int line = 0;
    std::vector<EdgeSide> sides;  // in order around the face
    bool has_body = false;        // true if the file has a body for this face
};

/// A body with its number and line in the file.
struct Body {
    int id = 0;
    int line = 0;
    std::size_t face = 0;   // index in Mesh::faces
    bool reversed = false;  // true if the file gives the number of the face with a minus sign
    std::optional<double> volume;
    std::optional<double> pressure;  // the Lagrange multiplier in the file
};

/// The elements of a data file. Each vector is in the order of the file.
struct Mesh {
    // Includes the midpoints of the edges of a quadratic model. No Edge refers to them.
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Body> bodies;
    // Number of elements that the file fixes or constrains. foamtex moves these elements freely.
    int constrained_count = 0;
    // For error messages: the line of the keyword `read` after the elements, or of the end of the
    // file.
    int end_line = 0;
};

/// Reads the sections of vertices, edges, faces and bodies, up to the keyword `read` or the end of
/// the file. Skips attributes that foamtex does not use. Throws FormatError if a section is missing
/// or malformed, or refers to an element that the file does not define. Also throws FormatError if
/// an attribute, such as `boundary`, changes the physics in a way that foamtex does not support.
Mesh read_mesh(TokenReader& tokens, const Parameters& parameters);

}  // namespace foam::evolver
