// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_json.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace foam {

namespace {

// Returns the text of a number, with the fewest digits that read back to the same bits, and with a
// point or an exponent. The text "-0", which has neither, would be read as the integer 0, and the
// sign would be lost. Precondition: the number is finite.
std::string real(double number) {
    constexpr std::size_t kMaxDigits = 32;  // the text of a double has at most 24 characters
    std::array<char, kMaxDigits> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    const std::string text(static_cast<const char*>(digits.data()), end);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

class FoamJsonWriter {
  public:
    explicit FoamJsonWriter(const Foam& foam) : foam_(foam) {}

    std::string write() {
        put("{{\n\"format\": \"foamtex-foam\",\n\"version\": {},\n", needs_version_2() ? 2 : 1);
        put_torus();
        put("\"film_tension\": {},\n\"time\": {},\n", real(foam_.film_tension), real(foam_.time));
        put("\"next_identity\": {},\n", foam_.next_identity);
        put_rows("junctions", foam_.network.junctions(), &FoamJsonWriter::put_junction);
        put(",\n");
        put_rows("films", foam_.network.films(), &FoamJsonWriter::put_film);
        put(",\n");
        put_rows("bubbles", foam_.network.bubbles(), &FoamJsonWriter::put_bubble);
        if (is_patch()) {
            put(",\n");
            put_ghost();
            put_rows("half_angles", foam_.network.films(), &FoamJsonWriter::put_half_angle);
            put(",\n");
            put_rows("lone_bubbles", foam_.lone_bubbles, &FoamJsonWriter::put_lone_bubble);
        }
        put("\n}}\n");
        return std::move(text_);
    }

  private:
    bool needs_version_2() const { return is_patch() || foam_.domain.shear != 0.0; }

    bool is_patch() const { return foam_.network.ghost() != kNone<BubbleId>; }

    template <class... Values>
    void put(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

    // Writes the shear only if it is not 0, because version 1 has no shear.
    void put_torus() {
        put("\"torus\": [{}, {}", real(foam_.domain.width), real(foam_.domain.height));
        if (foam_.domain.shear != 0.0) {
            put(", {}", real(foam_.domain.shear));
        }
        put("],\n");
    }

    template <class Rows, class Row>
    void put_rows(const char* name, const Rows& rows, void (FoamJsonWriter::*put_row)(Row)) {
        put("\"{}\": [", name);
        const char* separator = "\n";
        for (const auto& row : rows) {
            put("{}", std::exchange(separator, ",\n"));
            (this->*put_row)(row);
        }
        put("\n]");
    }

    void put_ghost() {
        const Network& network = foam_.network;
        const int sides = network.sides(network.ghost());
        put("\"ghost\": [{}, {}],\n",
            sides > 0 ? index_of(network.first(network.ghost())) : 0,
            sides);
    }

    void put_half_angle(FilmId film) {
        put("{}", real(foam_.network.is_outer(film) ? foam_.half_angles[film] : 0.0));
    }

    void put_lone_bubble(const LoneBubble& bubble) {
        put("[{}, {}, {}, {}]",
            bubble.identity,
            real(bubble.center.x()),
            real(bubble.center.y()),
            real(bubble.target_area));
    }

    void put_junction(JunctionId junction) {
        const Vec2& position = foam_.positions[junction];
        put("[{}, {}, {}]",
            real(position.x()),
            real(position.y()),
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
        put("[{}, {}, {}, {}, {}]",
            foam_.identities[bubble],
            real(foam_.pressures[bubble]),
            real(foam_.target_areas[bubble]),
            index_of(foam_.network.first(bubble)),
            foam_.network.sides(bubble));
    }

    const Foam& foam_;
    std::string text_;
};

}  // namespace

std::string write_foam_json(const Foam& foam) {
    if (foam.network.is_compact()) {
        return FoamJsonWriter(foam).write();
    }
    Foam compacted = foam;
    compact(compacted);
    return FoamJsonWriter(compacted).write();
}

}  // namespace foam
