#include "core/io/foam_json.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace foam {

namespace {

// Real numbers are written with a point or an exponent, so that -0.0 keeps its sign, and in the
// fewest digits that read back to the same bits.
class Writer {
  public:
    explicit Writer(const Foam& foam) : foam_(foam) {}

    std::string write() {
        put("{{\n\"format\": \"foamtex-foam\",\n\"version\": {},\n", kFoamJsonVersion);
        put("\"torus\": [{:#}, {:#}],\n", foam_.torus.width, foam_.torus.height);
        put("\"film_tension\": {:#},\n\"time\": {:#},\n", foam_.film_tension, foam_.time);
        put("\"next_identity\": {},\n", foam_.next_identity);
        put_rows("junctions", foam_.network.junctions(), &Writer::put_junction);
        put(",\n");
        put_rows("films", foam_.network.films(), &Writer::put_film);
        put(",\n");
        put_rows("bubbles", foam_.network.bubbles(), &Writer::put_bubble);
        put("\n}}\n");
        return std::move(text_);
    }

  private:
    template <class... Values>
    void put(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

    template <class Id>
    void put_rows(const char* name, const LiveRange<Id>& ids, void (Writer::*put_row)(Id)) {
        put("\"{}\": [", name);
        const char* separator = "\n";
        for (const Id id : ids) {
            put("{}", std::exchange(separator, ",\n"));
            (this->*put_row)(id);
        }
        put("\n]");
    }

    void put_junction(JunctionId junction) {
        const Vec2& position = foam_.positions[junction];
        put("[{:#}, {:#}, {}]",
            position.x(),
            position.y(),
            index_of(foam_.network.outgoing(junction)));
    }

    void put_film(FilmId film) {
        const Network& network = foam_.network;
        const HalfEdgeId h = forward_side(film);
        put("[{}, {}, {}, {}, {}, {}, {}, {}, {}]",
            index_of(network.tail(h)),
            index_of(network.head(h)),
            index_of(network.left(h)),
            index_of(network.right(h)),
            index_of(network.next(h)),
            index_of(network.next(twin(h))),
            network.offset(h).i,
            network.offset(h).j,
            foam_.t1_armed[film] != 0 ? 1 : 0);
    }

    void put_bubble(BubbleId bubble) {
        put("[{}, {:#}, {:#}, {}, {}]",
            foam_.identities[bubble],
            foam_.pressures[bubble],
            foam_.target_areas[bubble],
            index_of(foam_.network.first(bubble)),
            foam_.network.sides(bubble));
    }

    const Foam& foam_;
    std::string text_;
};

bool has_dead_slots(const Network& network) {
    return network.junction_slots() != network.junction_count() ||
           network.film_slots() != network.film_count() ||
           network.bubble_slots() != network.bubble_count();
}

}  // namespace

std::string write_foam_json(const Foam& foam) {
    if (!has_dead_slots(foam.network)) {
        return Writer(foam).write();
    }
    Foam dense = foam;
    compact(dense);
    return Writer(dense).write();
}

}  // namespace foam
