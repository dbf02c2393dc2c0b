// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_json.h"
#include "core/io/json_item.h"
#include "core/network/validate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_set>
#include <utility>

namespace foam {

namespace {

// Largest relative difference that is accepted between the sum of the target areas and the area of
// the torus. Time steps keep the two equal except for rounding.
constexpr double kAreaTolerance = 1e-6;
// Largest accepted distance of a position from the fundamental cell of the torus, in periods.
// Rounding can put a position slightly outside.
constexpr double kCellSlack = 1e-9;

class Reader {
  public:
    Reader(const JsonTree& root, const std::string& file) : root_(root, file) {}

    Foam read() {
        check_format();
        read_scalars();
        for_each_element("junctions", [this](const JsonItem& item) { read_junction(item); });
        count_films_and_bubbles();
        for_each_element("films", [this](const JsonItem& item) { read_film(item); });
        for_each_element("bubbles", [this](const JsonItem& item) { read_bubble(item); });
        if (foam_.domain.is_plane()) {
            read_patch();
        }
        set_outgoing();
        check_foam();
        return std::move(foam_);
    }

  private:
    template <class ReadElement>
    void for_each_element(const char* name, const ReadElement& read_element) const {
        const JsonItem list = root_.member(name);
        for (std::size_t k = 0; k < list.size(); ++k) {
            read_element(list.element(k));
        }
    }

    HalfEdgeId half_edge(const JsonItem& item) const {
        return id_at<HalfEdgeId>(item.index(2 * film_count_, "half-edge"));
    }

    void check_format() const {
        const JsonItem format = root_.member("format");
        if (!format.is_text("foamtex-foam")) {
            format.fail("must be \"foamtex-foam\", otherwise the file is not a foam state");
        }
        const JsonItem item = root_.member("version");
        const double version = item.integer(1.0, 1e9);
        if (version > kFoamJsonVersion) {
            item.fail(fmt::format(
                "foam state version {} is not supported; this program reads versions 1 to {}",
                version,
                kFoamJsonVersion));
        }
    }

    void read_scalars() {
        read_torus(root_.member("torus"));
        foam_.film_tension = root_.member("film_tension").positive();
        foam_.time = root_.member("time").number();
        foam_.next_identity =
            static_cast<BubbleIdentity>(root_.member("next_identity").integer(0.0, kNoIndex - 1.0));
    }

    // Reads the width, the height and, if there is a third number, the shear. A width and a height
    // of 0 mean the plane.
    void read_torus(const JsonItem& item) {
        const bool has_shear = item.size() == 3;
        item.expect_size(has_shear ? 3 : 2);
        const JsonItem width = item.value(0);
        const JsonItem height = item.value(1);
        const bool is_plane = width.number() == 0.0 && height.number() == 0.0;
        foam_.domain = is_plane ? kPlane : Domain{width.positive(), height.positive()};
        if (!is_plane && !has_moderate_shape(foam_.domain)) {
            item.fail(
                fmt::format("the width and the height of the torus must differ by at most the "
                            "factor {}, but are {} and {}",
                            kMaxAspect,
                            foam_.domain.width,
                            foam_.domain.height));
        }
        if (has_shear) {
            foam_.domain.shear = item.value(2).number();
        }
        if (std::abs(foam_.domain.shear) > foam_.domain.width) {
            item.fail(fmt::format(
                "the shear of the torus is {1}, but must be from -{0} to {0} (its width)",
                foam_.domain.width,
                foam_.domain.shear));
        }
    }

    void read_junction(const JsonItem& item) {
        item.expect_size(3);
        const Vec2 position(item.value(0).number(), item.value(1).number());
        if (!foam_.domain.is_plane() && !(is_inside(position.x(), foam_.domain.width) &&
                                          is_inside(position.y(), foam_.domain.height))) {
            item.fail(fmt::format(
                "the position ({}, {}) is outside of the torus", position.x(), position.y()));
        }
        foam_.network.add_junction();
        foam_.positions.push_back(position);
    }

    static bool is_inside(double coordinate, double period) {
        return coordinate >= -kCellSlack * period && coordinate < (1.0 + kCellSlack) * period;
    }

    void count_films_and_bubbles() {
        film_count_ = root_.member("films").size();
        bubble_count_ = root_.member("bubbles").size();
        if (film_count_ > std::numeric_limits<std::int32_t>::max() / 2) {
            root_.member("films").fail(fmt::format("{} films are too many", film_count_));
        }
    }

    void read_film(const JsonItem& item) {
        item.expect_size(9);
        const std::size_t regions =
            bubble_count_ + (foam_.domain.is_plane() ? 1 : 0);  // with the ghost
        const HalfEdgeId h = forward_side(foam_.network.add_film());
        foam_.network.set_tail(h, junction(item.value(0)));
        foam_.network.set_tail(twin(h), junction(item.value(1)));
        foam_.network.set_left(h, id_at<BubbleId>(item.value(2).index(regions, "bubble")));
        foam_.network.set_left(twin(h), id_at<BubbleId>(item.value(3).index(regions, "bubble")));
        foam_.network.set_next(h, half_edge(item.value(4)));
        foam_.network.set_next(twin(h), half_edge(item.value(5)));
        foam_.network.set_offset(h, {periods(item.value(6)), periods(item.value(7))});
        foam_.t1_armed.push_back(static_cast<std::uint8_t>(item.value(8).integer(0.0, 1.0)));
    }

    JunctionId junction(const JsonItem& item) const {
        return id_at<JunctionId>(item.index(foam_.network.junction_slots(), "junction"));
    }

    static std::int32_t periods(const JsonItem& item) {
        return static_cast<std::int32_t>(item.integer(-kMaxPeriods, kMaxPeriods));
    }

    // Reads a number of sides.
    int sides(const JsonItem& item) const {
        return static_cast<int>(item.integer(0.0, 2.0 * static_cast<double>(film_count_)));
    }

    void read_bubble(const JsonItem& item) {
        item.expect_size(5);
        const BubbleId bubble = foam_.network.add_bubble();
        foam_.identities.push_back(identity(item.value(0)));
        foam_.pressures.push_back(item.value(1).number());
        foam_.target_areas.push_back(item.value(2).positive());
        foam_.network.set_first(bubble, half_edge(item.value(3)));
        foam_.network.set_sides(bubble, sides(item.value(4)));
    }

    BubbleIdentity identity(const JsonItem& item) {
        const auto found = static_cast<BubbleIdentity>(item.integer(0.0, kNoIndex - 1.0));
        if (found >= foam_.next_identity) {
            item.fail(fmt::format(
                "expected an identity below {} (the value of 'next_identity'), found {}",
                foam_.next_identity,
                found));
        }
        if (!identities_.insert(found).second) {
            item.fail(fmt::format("duplicate bubble identity {}", found));
        }
        return found;
    }

    void read_patch() {
        const JsonItem ghost_item = root_.member("ghost");
        ghost_item.expect_size(2);
        const BubbleId ghost = foam_.network.add_ghost();
        const int ghost_sides = sides(ghost_item.value(1));
        foam_.network.set_sides(ghost, ghost_sides);
        foam_.network.set_first(
            ghost, ghost_sides > 0 ? half_edge(ghost_item.value(0)) : kNone<HalfEdgeId>);
        complete_patch(foam_);
        const JsonItem angles = root_.member("half_angles");
        angles.expect_size(film_count_);
        for (const FilmId film : foam_.network.films()) {
            foam_.half_angles[film] = half_angle(angles.element(index_of(film)));
        }
        for_each_element("lone_bubbles", [this](const JsonItem& item) {
            item.expect_size(4);
            foam_.lone_bubbles.push_back({identity(item.value(0)),
                                          {item.value(1).number(), item.value(2).number()},
                                          item.value(3).positive()});
        });
        std::ranges::sort(foam_.lone_bubbles, {}, &LoneBubble::identity);
    }

    static double half_angle(const JsonItem& item) {
        const double angle = item.number();
        if (!(std::abs(angle) < std::numbers::pi)) {
            item.fail(fmt::format("expected an angle between -pi and pi, found {}", angle));
        }
        return angle;
    }

    // Sets the outgoing half-edge of each junction to the outgoing half-edge in the file. This must
    // be done after all films are read, because set_tail in read_film also sets outgoing
    // half-edges.
    void set_outgoing() {
        const JsonItem junctions = root_.member("junctions");
        for (const JunctionId junction : foam_.network.junctions()) {
            const JsonItem item = junctions.element(index_of(junction)).value(2);
            const HalfEdgeId h = half_edge(item);
            if (foam_.network.tail(h) != junction) {
                item.fail(fmt::format(
                    "half-edge {} does not leave junction {}", index_of(h), index_of(junction)));
            }
            foam_.network.set_tail(h, junction);
        }
    }

    void check_foam() const {
        if (film_count_ == 0 && foam_.lone_bubbles.empty()) {
            root_.member("films").fail("the foam has no films and no lone bubbles");
        }
        if (const auto fault = find_fault(foam_.network)) {
            root_.member("films").fail(fmt::format("the foam is not valid: {}", *fault));
        }
        if (foam_.domain.is_plane()) {
            return;
        }
        double sum = 0.0;
        for (const BubbleId bubble : foam_.network.bubbles()) {
            sum += foam_.target_areas[bubble];
        }
        if (!(std::abs(sum / foam_.domain.area() - 1.0) < kAreaTolerance)) {
            root_.member("bubbles").fail(
                fmt::format("the target areas add up to {}, but the torus has an area of {}",
                            sum,
                            foam_.domain.area()));
        }
    }

    JsonItem root_;
    Foam foam_;
    std::size_t film_count_ = 0;
    std::size_t bubble_count_ = 0;
    std::unordered_set<BubbleIdentity> identities_;
};

}  // namespace

Foam read_foam_json(std::string_view text, const std::string& file) {
    const JsonTree root = parse_json(text, file);
    return Reader(root, file).read();
}

}  // namespace foam
