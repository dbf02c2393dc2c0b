// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace foam {

namespace {

// Surface Evolver calls the lattice offset of an edge its wrap. The numeric form of a wrap has six
// bits per axis. The lower five of them store the number of periods, in two's complement.
constexpr unsigned kWrapBits = 6;
constexpr std::int32_t kMinWrap = -16;
constexpr std::int32_t kMaxWrap = 15;

// Returns the number that each live element has in the file: 1, 2, ... by increasing id. Dead slots
// have the number 0.
template <class Id>
Indexed<Id, int> numbers(const LiveRange<Id>& live, std::size_t slots) {
    Indexed<Id, int> result(slots, 0);
    int number = 0;
    for (const Id id : live) {
        result[id] = ++number;
    }
    return result;
}

class EvolverWriter {
  public:
    EvolverWriter(const Foam& foam, EvolverEdges edges)
        : foam_(foam),
          arcs_(edges == EvolverEdges::Arcs),
          junctions_(numbers(foam.network.junctions(), foam.network.junction_slots())),
          films_(numbers(foam.network.films(), foam.network.film_slots())),
          bubbles_(numbers(foam.network.bubbles(), foam.network.bubble_slots())) {}

    std::string write() {
        write_top();
        write_vertices();
        write_edges();
        write_faces();
        write_bodies();
        put("\nread\n");
        return std::move(text_);
    }

  private:
    template <class... Values>
    void put(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

    void write_top() {
        put("// A foam of {} bubbles {}\n\n",
            foam_.network.bubble_count(),
            foam_.domain.is_plane() ? "in the plane" : "on a torus");
        put("STRING\nSPACE_DIMENSION 2\n");
        put("LENGTH_METHOD_NAME \"circular_arc_length\"\n");
        put("AREA_METHOD_NAME \"circular_arc_area\"\n");
        put("{}\n", arcs_ ? "QUADRATIC" : "LINEAR");
        if (!foam_.domain.is_plane()) {
            put("TORUS_FILLED\nPERIODS\n{} 0\n{} {}\n",
                foam_.domain.width,
                foam_.domain.shear,
                foam_.domain.height);
        }
    }

    // Writes the junctions and then, if films are arcs, the midpoints of the films. A midpoint is
    // not wrapped: if its film leaves the fundamental cell, the midpoint may be outside of this
    // cell.
    void write_vertices() {
        put("\nvertices\n");
        for (const JunctionId junction : foam_.network.junctions()) {
            write_vertex(junctions_[junction], foam_.positions[junction]);
        }
        for (const FilmId film : foam_.network.films()) {
            const HalfEdgeId h = forward_side(film);
            if (arcs_) {
                write_vertex(
                    midpoint(film),
                    foam_.positions[foam_.network.tail(h)] + point_at(film_arc(foam_, h), 0.5));
            }
        }
    }

    void write_vertex(int number, const Vec2& point) {
        put("{} {} {}\n", number, point.x(), point.y());
    }

    // Returns the number of the vertex that is the midpoint of a film.
    int midpoint(FilmId film) const {
        return static_cast<int>(foam_.network.junction_count()) + films_[film];
    }

    void write_edges() {
        put("\nedges\n");
        for (const FilmId film : foam_.network.films()) {
            const HalfEdgeId h = forward_side(film);
            put("{} {} {}",
                films_[film],
                junctions_[foam_.network.tail(h)],
                junctions_[foam_.network.head(h)]);
            if (arcs_) {
                put(" /*midpt*/ {}", midpoint(film));
            }
            if (!foam_.domain.is_plane()) {
                write_wrap(films_[film], foam_.network.offset(h));
            }
            if (foam_.film_tension != 1.0) {
                put(" tension {}", foam_.film_tension);
            }
            put("\n");
        }
    }

    // Writes the wrap of an edge. A wrap of at most one period along each axis is written as two
    // symbols, each of them '*', '+' or '-'. Any other wrap is written as a number.
    void write_wrap(int edge, LatticeOffset offset) {
        const auto is_symbol = [](std::int32_t periods) { return -1 <= periods && periods <= 1; };
        if (is_symbol(offset.i) && is_symbol(offset.j)) {
            put(" {} {}", symbol(offset.i), symbol(offset.j));
        } else {
            put(" wrap {}", wrap_bits(edge, offset.i) | (wrap_bits(edge, offset.j) << kWrapBits));
        }
    }

    static char symbol(std::int32_t periods) {
        return periods == 0 ? '*' : (periods > 0 ? '+' : '-');
    }

    // Returns the lower five bits of a number of periods. Throws std::range_error if the number
    // needs more bits.
    static unsigned wrap_bits(int edge, std::int32_t periods) {
        if (periods < kMinWrap || periods > kMaxWrap) {
            throw std::range_error(
                fmt::format("edge {} wraps {} times around the torus; a Surface Evolver file can "
                            "store only {} to {}",
                            edge,
                            periods,
                            kMinWrap,
                            kMaxWrap));
        }
        return static_cast<unsigned>(periods) & 0x1fU;
    }

    void write_faces() {
        put("\nfaces\n");
        for (const BubbleId bubble : foam_.network.bubbles()) {
            put("{}", bubbles_[bubble]);
            for (const HalfEdgeId h : foam_.network.around(bubble)) {
                put(" {}", is_forward(h) ? films_[film_of(h)] : -films_[film_of(h)]);
            }
            put("\n");
        }
    }

    // On a torus, pressures are written relative to the pressure of the first bubble.
    void write_bodies() {
        put("\nbodies\n");
        double reference = 0.0;
        for (const BubbleId bubble : foam_.network.bubbles()) {
            const int number = bubbles_[bubble];
            if (number == 1 && !foam_.domain.is_plane()) {
                reference = foam_.pressures[bubble];
            }
            put("{} {} volume {} lagrange_multiplier {}\n",
                number,
                number,
                foam_.target_areas[bubble],
                foam_.pressures[bubble] - reference);
        }
    }

    const Foam& foam_;
    bool arcs_;
    Indexed<JunctionId, int> junctions_;
    Indexed<FilmId, int> films_;
    Indexed<BubbleId, int> bubbles_;
    std::string text_;
};

}  // namespace

std::string write_evolver(const Foam& foam, EvolverEdges edges) {
    if (!foam.lone_bubbles.empty()) {
        throw std::range_error(
            fmt::format("a Surface Evolver file cannot store bubbles without neighbors, of which "
                        "this foam has {}; "
                        "use a .json file",
                        foam.lone_bubbles.size()));
    }
    return EvolverWriter(foam, edges).write();
}

}  // namespace foam
