// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_loops.h"

#include "core/foam/lattice.h"
#include "core/io/format_error.h"
#include "core/network/validate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

// Converts faces to loops of films. First, the wrap of every edge is determined: the lattice offset
// of the copy of the head at which the edge ends. Then the loop of edges of each face is copied; if
// the face's body refers to the reversed face, the loop is reversed. Two checks follow: the loops
// must be closed, and each side of an edge must have one face. In the plane, one of the two sides
// of an edge may have no face. If the total area of all loops is negative, the loops are clockwise,
// and all of them are reversed. Finally, each loop is split into films at vertices with three
// edges.

namespace foam::evolver {

namespace {

constexpr double kMaxCoordinate = 1e6;    // largest |coordinate| of a vertex, in periods
constexpr double kCoverTolerance = 1e-6;  // relative tolerance of the sum of the areas of faces

using Loop = std::vector<EdgeSide>;

class LoopBuilder {
  public:
    LoopBuilder(const Mesh& mesh, const Domain& domain, const std::string& file)
        : mesh_(mesh), lattice_(reduced_lattice(domain)), domain_(lattice_.domain), file_(file) {}

    std::vector<FilmLoop> build() {
        check_points();
        resolve_wraps();
        take_loops();
        for (std::size_t face = 0; face < loops_.size(); ++face) {
            check_loop(mesh_.faces[face], loops_[face]);
        }
        check_sides();
        orient();
        count_edges();
        return split_all();
    }

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw FormatError(file_, line, message);
    }

    int id(EdgeSide side) const { return mesh_.edges[side.edge].id; }
    std::size_t tail(EdgeSide side) const {
        return side.forward ? mesh_.edges[side.edge].tail : mesh_.edges[side.edge].head;
    }
    std::size_t head(EdgeSide side) const { return tail({side.edge, !side.forward}); }
    LatticeOffset wrap(EdgeSide side) const {
        return side.forward ? wraps_[side.edge] : -wraps_[side.edge];
    }
    Vec2 chord(EdgeSide side) const {
        return mesh_.vertices[head(side)].point + domain_.translation(wrap(side)) -
               mesh_.vertices[tail(side)].point;
    }

    void check_points() const {
        if (domain_.is_plane()) {
            return;
        }
        for (const Vertex& vertex : mesh_.vertices) {
            if (std::abs(vertex.point.x()) > kMaxCoordinate * domain_.width ||
                std::abs(vertex.point.y()) > kMaxCoordinate * domain_.height) {
                fail(vertex.line,
                     fmt::format(
                         "vertex {} is too far from the origin; must be within {:.0f} periods",
                         vertex.id,
                         kMaxCoordinate));
            }
        }
    }

    // Sets the wrap of every edge, as an offset of the reduced lattice. In the plane all wraps are
    // zero.
    void resolve_wraps() {
        const bool wrapped = std::any_of(mesh_.edges.begin(),
                                         mesh_.edges.end(),
                                         [](const Edge& edge) { return edge.wrap.has_value(); });
        for (const Edge& edge : mesh_.edges) {
            if (domain_.is_plane()) {
                wraps_.emplace_back();
                continue;
            }
            wraps_.push_back(wrapped ? lattice_.reduced(edge.wrap.value_or(LatticeOffset{}))
                                     : nearest_copy(edge));
        }
    }

    // Returns the lattice offset of the copy of the head that is nearest to the tail. On a sheared
    // torus, chooses the nearest row of copies first, and then the nearest copy in this row.
    LatticeOffset nearest_copy(const Edge& edge) const {
        const Vec2 back = mesh_.vertices[edge.tail].point - mesh_.vertices[edge.head].point;
        const auto j = static_cast<std::int32_t>(std::lround(back.y() / domain_.height));
        const double along = back.x() - j * domain_.shear;
        return {static_cast<std::int32_t>(std::lround(along / domain_.width)), j};
    }

    // Copies the loop of each face. Reverses the copy if the face's body refers to the reversed
    // face.
    void take_loops() {
        for (const Face& face : mesh_.faces) {
            loops_.push_back(face.sides);
        }
        for (const Body& body : mesh_.bodies) {
            if (body.reversed) {
                reverse(loops_[body.face]);
            }
        }
    }

    static void reverse(Loop& loop) {
        std::reverse(loop.begin(), loop.end());
        for (EdgeSide& side : loop) {
            side.forward = !side.forward;
        }
    }

    void check_loop(const Face& face, const Loop& loop) const {
        LatticeOffset around;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const EdgeSide& next = loop[(k + 1) % loop.size()];
            if (head(loop[k]) != tail(next)) {
                fail(face.line,
                     fmt::format("face {}: edge {} does not begin where edge {} ends",
                                 face.id,
                                 id(next),
                                 id(loop[k])));
            }
            around = around + wrap(loop[k]);
            if (exceeds_max_periods(around)) {
                fail(face.line,
                     fmt::format("face {}: its edges lead more than {} periods away from its first "
                                 "vertex",
                                 face.id,
                                 kMaxPeriods));
            }
        }
        if (around != LatticeOffset{}) {
            fail(face.line,
                 fmt::format("face {}: the wraps of its edges must add up to zero", face.id));
        }
    }

    // Checks that every edge has one face on each side. In the plane, an edge may have a face on
    // one side only.
    void check_sides() const {
        std::vector<int> faces(2 * mesh_.edges.size(), 0);
        for (std::size_t face = 0; face < loops_.size(); ++face) {
            for (const EdgeSide& side : loops_[face]) {
                if (faces[2 * side.edge + (side.forward ? 0 : 1)]++ > 0) {
                    fail(mesh_.faces[face].line,
                         fmt::format("face {}: edge {} already has a face on that side",
                                     mesh_.faces[face].id,
                                     id(side)));
                }
            }
        }
        for (std::size_t edge = 0; edge < mesh_.edges.size(); ++edge) {
            const int count = faces[2 * edge] + faces[2 * edge + 1];
            if (count < (domain_.is_plane() ? 1 : 2)) {
                fail(mesh_.edges[edge].line,
                     fmt::format("edge {} has no face on {} side",
                                 mesh_.edges[edge].id,
                                 count == 0 ? "either" : "one"));
            }
        }
    }

    double polygon_area(const Loop& loop) const {
        double twice_area = 0.0;
        Vec2 corner = Vec2::Zero();
        for (const EdgeSide& side : loop) {
            const Vec2 d = chord(side);
            twice_area += cross(corner, d);
            corner += d;
        }
        return 0.5 * twice_area;
    }

    // Reverses all loops if their total area is negative. If all loops have the same direction,
    // they are counter-clockwise afterwards. Throws FormatError if the loops do not cover the torus
    // once.
    void orient() {
        double total = 0.0;
        for (const Loop& loop : loops_) {
            total += polygon_area(loop);
        }
        if (!domain_.is_plane() &&
            !(std::abs(std::abs(total) / domain_.area() - 1.0) < kCoverTolerance)) {
            fail(mesh_.end_line, "the faces do not cover the torus exactly once");
        }
        if (total < 0.0) {
            std::for_each(loops_.begin(), loops_.end(), reverse);
        }
    }

    // Counts the edges at each vertex. Throws FormatError if a vertex joins one edge or more than
    // three.
    void count_edges() {
        edge_counts_.assign(mesh_.vertices.size(), 0);
        for (const Edge& edge : mesh_.edges) {
            ++edge_counts_[edge.tail];
            ++edge_counts_[edge.head];
        }
        for (std::size_t k = 0; k < edge_counts_.size(); ++k) {
            const int count = edge_counts_[k];
            if (count == 1 || count > 3) {
                fail(mesh_.vertices[k].line,
                     fmt::format("vertex {} joins {} edge{}; must join two or three",
                                 mesh_.vertices[k].id,
                                 count,
                                 count == 1 ? "" : "s"));
            }
        }
    }

    bool begins_at_junction(EdgeSide side) const { return edge_counts_[tail(side)] == 3; }

    std::vector<FilmLoop> split_all() const {
        std::vector<FilmLoop> all;
        for (std::size_t face = 0; face < loops_.size(); ++face) {
            all.push_back(split(mesh_.faces[face], loops_[face]));
        }
        return all;
    }

    // Splits the loop of a face into films. The first film starts at the first junction of the
    // loop.
    FilmLoop split(const Face& face, Loop loop) const {
        const auto first = std::find_if(
            loop.begin(), loop.end(), [this](EdgeSide side) { return begins_at_junction(side); });
        if (first == loop.end()) {
            fail(face.line, fmt::format("face {} has no vertex that joins three edges", face.id));
        }
        std::rotate(loop.begin(), first, loop.end());
        FilmLoop films{{}, polygon_area(loop)};
        for (const EdgeSide& side : loop) {
            if (begins_at_junction(side)) {
                films.films.push_back({side, side, tail(side), {}});
            }
            films.films.back().last = side;
            films.films.back().offset = films.films.back().offset + wrap(side);
        }
        return films;
    }

    const Mesh& mesh_;
    ReducedLattice lattice_;
    const Domain& domain_;  // lattice_.domain, whose shear is reduced
    const std::string& file_;
    std::vector<LatticeOffset> wraps_;  // per edge
    std::vector<Loop> loops_;           // per face
    std::vector<int> edge_counts_;      // number of edges at each vertex
};

}  // namespace

std::vector<FilmLoop> film_loops(const Mesh& mesh, const Domain& domain, const std::string& file) {
    return LoopBuilder(mesh, domain, file).build();
}

}  // namespace foam::evolver
