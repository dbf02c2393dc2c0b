// SPDX-License-Identifier: Apache-2.0

#include "core/foam/lattice.h"
#include "core/io/evolver_file.h"
#include "core/io/evolver_loops.h"
#include "core/io/format_error.h"
#include "core/network/ghost_boundary.h"
#include "core/network/validate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Builds the foam from the loops of films around the faces (evolver_loops.h). Vertices at which
// films meet become junctions, each film becomes two half-edges, and each face becomes a bubble.
// Half-edges without a face belong to the ghost. Target areas and pressures come from the bodies;
// in two dimensions, Surface Evolver's "volume" of a body is the area of its face.

namespace foam {

namespace evolver {

namespace {

// Largest relative difference that is accepted between the sum of the volumes and the area of the
// torus. Rounding the volumes to six digits causes a smaller difference.
constexpr double kVolumeTolerance = 1e-5;
// If the relative difference is larger than this, the volumes are scaled to the area of the torus.
// A smaller difference can come from rounding errors of the sum.
constexpr double kVolumeRounding = 1e-12;

class FoamBuilder {
  public:
    FoamBuilder(const Header& header, const Mesh& mesh, const std::string& file)
        : header_(header), mesh_(mesh), file_(file) {}

    Foam build() {
        foam_.domain = reduced_lattice(header_.domain).domain;
        foam_.film_tension = film_tension();
        loops_ = film_loops(mesh_, header_.domain, file_);
        add_junctions();
        add_films();
        for (const FilmLoop& loop : loops_) {
            add_bubble(loop);
        }
        if (foam_.domain.is_plane()) {
            add_ghost_boundary(foam_.network);
        }
        if (const auto fault = find_fault(foam_.network)) {
            fail(mesh_.end_line, fmt::format("the faces do not form a valid foam: {}", *fault));
        }
        place_junctions();
        set_areas_and_pressures();
        if (foam_.domain.is_plane()) {
            complete_patch(foam_);
        }
        return std::move(foam_);
    }

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw FormatError(file_, line, message);
    }

    double film_tension() const {
        if (mesh_.edges.empty()) {
            fail(mesh_.end_line, "the file has no edges");
        }
        const Edge& first = mesh_.edges.front();
        for (const Edge& edge : mesh_.edges) {
            if (edge.tension != first.tension) {
                fail(edge.line,
                     fmt::format("edge {} has tension {}, but edge {} has {}; all films must have "
                                 "the same tension",
                                 edge.id,
                                 edge.tension,
                                 first.id,
                                 first.tension));
            }
        }
        const double tension = first.tension + header_.added_tension;
        if (!(tension > 0.0 && std::isfinite(tension))) {
            fail(first.line,
                 fmt::format("the film tension must be positive and finite, not {}", tension));
        }
        return tension;
    }

    void add_junctions() {
        junctions_.assign(mesh_.vertices.size(), kNone<JunctionId>);
        std::vector<bool> used(mesh_.vertices.size(), false);
        for (const FilmLoop& loop : loops_) {
            for (const FilmSide& film : loop.films) {
                used[film.tail] = true;
            }
        }
        for (std::size_t k = 0; k < used.size(); ++k) {
            if (used[k]) {
                junctions_[k] = foam_.network.add_junction();
                foam_.positions.push_back(mesh_.vertices[k].point);
            }
        }
    }

    // Returns the index in half_edges_ at which a side of an edge is stored.
    static std::size_t index(EdgeSide side) { return 2 * side.edge + (side.forward ? 0 : 1); }
    static std::size_t twin_index(EdgeSide side) { return index(side) ^ 1U; }

    // Adds the films. A film between two faces has two sides in `loops_`, an outer film has one.
    // The side whose first edge has the smaller index() becomes the forward side. Films are ordered
    // by the index() of the first edge of the forward side.
    void add_films() {
        // For each side of an edge, the film side that begins with it.
        std::vector<const FilmSide*> films(2 * mesh_.edges.size(), nullptr);
        for (const FilmLoop& loop : loops_) {
            for (const FilmSide& film : loop.films) {
                films[index(film.first)] = &film;
            }
        }
        half_edges_.assign(films.size(), kNone<HalfEdgeId>);
        for (std::size_t side = 0; side < films.size(); ++side) {
            if (films[side] != nullptr && half_edges_[side] == kNone<HalfEdgeId>) {
                const HalfEdgeId h = forward_side(foam_.network.add_film());
                half_edges_[side] = h;
                half_edges_[twin_index(films[side]->last)] = twin(h);
                foam_.network.set_offset(h, films[side]->offset);
                foam_.t1_armed.push_back(1);
            }
        }
    }

    void add_bubble(const FilmLoop& loop) {
        const BubbleId bubble = foam_.network.add_bubble();
        const std::size_t sides = loop.films.size();
        for (std::size_t k = 0; k < sides; ++k) {
            const HalfEdgeId h = half_edges_[index(loop.films[k].first)];
            foam_.network.set_tail(h, junctions_[loop.films[k].tail]);
            foam_.network.set_left(h, bubble);
            foam_.network.set_next(h, half_edges_[index(loop.films[(k + 1) % sides].first)]);
        }
        foam_.network.set_first(bubble, half_edges_[index(loop.films.front().first)]);
        foam_.network.set_sides(bubble, static_cast<int>(sides));
        foam_.identities.push_back(foam_.next_identity++);
    }

    // Wraps the junctions of a torus into its fundamental cell. In the file, junctions may be
    // outside of this cell.
    void place_junctions() {
        for (const JunctionId junction : foam_.network.junctions()) {
            place_junction(foam_, junction, foam_.positions[junction]);
        }
    }

    void set_areas_and_pressures() {
        foam_.pressures.resize(mesh_.faces.size(), 0.0);
        foam_.target_areas.resize(mesh_.faces.size(), 0.0);
        for (const Body& body : mesh_.bodies) {
            const auto bubble = id_at<BubbleId>(body.face);
            foam_.pressures[bubble] = body.pressure.value_or(0.0);
            foam_.target_areas[bubble] = volume_of(body);
        }
        complete_areas();
        check_and_scale_areas();
    }

    // Returns the volume of the body, or 0 if it has none. Throws FormatError if the volume is not
    // positive.
    double volume_of(const Body& body) const {
        if (!body.volume) {
            return 0.0;
        }
        if (*body.volume <= 0.0) {
            fail(
                body.line,
                fmt::format("body {}: the volume must be positive, not {}", body.id, *body.volume));
        }
        return *body.volume;
    }

    // Completes missing target areas. One bubble of a torus may have no volume; it gets the rest of
    // the area of the torus. If every face has a body but no body has a volume, each bubble gets
    // the area of its polygon.
    void complete_areas() {
        std::vector<std::size_t> missing;
        double sum = 0.0;
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            const double area = foam_.target_areas[id_at<BubbleId>(face)];
            sum += area;
            if (area == 0.0) {
                missing.push_back(face);
            }
        }
        if (missing.size() == mesh_.faces.size() && missing.size() == mesh_.bodies.size()) {
            keep_areas();
        } else if (missing.size() == 1 && !foam_.domain.is_plane()) {
            foam_.target_areas[id_at<BubbleId>(missing.front())] = foam_.domain.area() - sum;
        } else if (!missing.empty()) {
            const Face& face = mesh_.faces[missing.back()];
            fail(face.line, fmt::format("face {} has no body with a volume", face.id));
        }
    }

    // Sets every target area to the area of the polygon of the face.
    void keep_areas() {
        for (std::size_t face = 0; face < loops_.size(); ++face) {
            foam_.target_areas[id_at<BubbleId>(face)] = loops_[face].polygon_area;
        }
    }

    // Checks that target areas are positive. On a torus, also checks that the relative difference
    // between their sum and the area of the torus is below kVolumeTolerance. If this difference
    // exceeds kVolumeRounding, scales the target areas to the area of the torus.
    void check_and_scale_areas() {
        double sum = 0.0;
        for (const BubbleId bubble : foam_.network.bubbles()) {
            if (!(foam_.target_areas[bubble] > 0.0)) {
                const Face& face = mesh_.faces[index_of(bubble)];
                fail(face.line,
                     fmt::format("face {} has no volume; the area computed for it is {}, but must "
                                 "be positive",
                                 face.id,
                                 foam_.target_areas[bubble]));
            }
            sum += foam_.target_areas[bubble];
        }
        if (foam_.domain.is_plane()) {
            return;
        }
        const double excess = sum / foam_.domain.area() - 1.0;
        if (!(std::abs(excess) < kVolumeTolerance)) {
            fail(mesh_.end_line,
                 fmt::format("the volumes add up to {}, but the torus has an area of {}",
                             sum,
                             foam_.domain.area()));
        }
        if (std::abs(excess) > kVolumeRounding) {
            for (double& area : foam_.target_areas) {
                area /= 1.0 + excess;
            }
        }
    }

    const Header& header_;
    const Mesh& mesh_;
    const std::string& file_;
    std::vector<FilmLoop> loops_;
    std::vector<JunctionId> junctions_;   // per vertex; kNone unless films begin at the vertex
    std::vector<HalfEdgeId> half_edges_;  // by index(); kNone unless a film begins with this side
    Foam foam_;
};

std::vector<std::string> notes_of(const Header& header, const Mesh& mesh) {
    std::vector<std::string> notes = header.notes;
    if (mesh.constrained_count > 0) {
        notes.push_back(fmt::format("fixed positions and constraints of {} element{} are ignored",
                                    mesh.constrained_count,
                                    mesh.constrained_count == 1 ? "" : "s"));
    }
    const bool no_volumes = std::none_of(
        mesh.bodies.begin(), mesh.bodies.end(), [](const Body& b) { return b.volume.has_value(); });
    if (no_volumes) {
        notes.emplace_back(
            "no body has a volume; each bubble keeps the area of its straight-edged polygon");
    }
    return notes;
}

}  // namespace

}  // namespace evolver

EvolverFoam read_evolver(std::string_view text, const std::string& file) {
    evolver::TokenReader tokens(text, file);
    const evolver::Header header = evolver::read_header(tokens);
    const evolver::Mesh mesh = evolver::read_mesh(tokens, header.parameters);
    return {evolver::FoamBuilder(header, mesh, file).build(), evolver::notes_of(header, mesh)};
}

}  // namespace foam
