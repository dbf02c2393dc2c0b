// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_json.h"
#include "core/io/format_error.h"
#include "core/io/json_tree.h"
#include "core/network/validate.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_set>
#include <utility>

namespace foam {

namespace {

// Largest relative difference between the sum of the target areas and the area of the torus. Time
// steps keep the two equal except for rounding.
constexpr double kAreaTolerance = 1e-6;
// Largest distance of a position from the fundamental cell of the torus, in periods. Rounding can
// put a position slightly outside.
constexpr double kCellSlack = 1e-9;

class Reader {
  public:
    Reader(const JsonTree& root, const std::string& file) : root_(root), file_(file) {}

    Foam read() {
        check_format();
        read_scalars();
        for (const JsonTree& item : array(member("junctions"))) {
            read_junction(item);
        }
        count_films_and_bubbles();
        for (const JsonTree& item : array(member("films"))) {
            read_film(item);
        }
        for (const JsonTree& item : array(member("bubbles"))) {
            read_bubble(item);
        }
        if (foam_.domain.is_plane()) {
            read_patch();
        }
        set_outgoing();
        check_foam();
        return std::move(foam_);
    }

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw FormatError(file_, line, message);
    }

    const JsonTree& member(const char* name) const {
        const JsonTree* found = root_.find(name);
        if (found == nullptr) {
            fail(root_.line, fmt::format("'{}' is missing", name));
        }
        return *found;
    }

    const JsonTree::Array& array(const JsonTree& value) const {
        const auto* items = std::get_if<JsonTree::Array>(&value.data);
        if (items == nullptr) {
            fail(value.line, "expected an array");
        }
        return *items;
    }

    // Returns the items of an array. Throws FormatError if it does not have the given size.
    const JsonTree::Array& row(const JsonTree& value, std::size_t size) const {
        const JsonTree::Array& items = array(value);
        if (items.size() != size) {
            fail(value.line,
                 fmt::format("expected an array of {} numbers, not {}", size, items.size()));
        }
        return items;
    }

    double number(const JsonTree& value) const {
        const double* found = std::get_if<double>(&value.data);
        if (found == nullptr || !std::isfinite(*found)) {
            fail(value.line, "expected a finite number");
        }
        return *found;
    }

    double positive(const JsonTree& value) const {
        const double found = number(value);
        if (!(found > 0.0)) {
            fail(value.line, fmt::format("expected a positive number, found {}", found));
        }
        return found;
    }

    double integer(const JsonTree& value, double min, double max) const {
        const double found = number(value);
        if (found != std::floor(found) || found < min || found > max) {
            fail(value.line,
                 fmt::format("expected an integer from {} to {}, found {}", min, max, found));
        }
        return found;
    }

    std::uint32_t index(const JsonTree& value, std::size_t size) const {
        return static_cast<std::uint32_t>(integer(value, 0.0, static_cast<double>(size) - 1.0));
    }

    HalfEdgeId half_edge(const JsonTree& value) const {
        return id_at<HalfEdgeId>(index(value, 2 * films_));
    }

    void check_format() const {
        const auto* format = std::get_if<std::string>(&member("format").data);
        if (format == nullptr || *format != "foamtex-foam") {
            fail(member("format").line, "not a foam state: 'format' must be \"foamtex-foam\"");
        }
        const double version = integer(member("version"), 1.0, 1e9);
        if (version > kFoamJsonVersion) {
            fail(member("version").line,
                 fmt::format(
                     "foam state version {} is not supported; this program reads versions 1 to {}",
                     version,
                     kFoamJsonVersion));
        }
    }

    void read_scalars() {
        read_torus(member("torus"));
        foam_.film_tension = positive(member("film_tension"));
        foam_.time = number(member("time"));
        foam_.next_identity = index(member("next_identity"), kNoIndex);
    }

    // Reads the width, the height and, if there is a third number, the shear. A width and a height
    // of 0 mean the plane.
    void read_torus(const JsonTree& item) {
        const std::size_t size = array(item).size() == 3 ? 3 : 2;
        const JsonTree::Array& domain = row(item, size);
        const bool is_plane = number(domain[0]) == 0.0 && number(domain[1]) == 0.0;
        foam_.domain = is_plane ? kPlane : Domain{positive(domain[0]), positive(domain[1])};
        if (size == 3) {
            foam_.domain.shear = number(domain[2]);
        }
        if (std::abs(foam_.domain.shear) > foam_.domain.width) {
            fail(item.line,
                 fmt::format("the shear of the torus must be from -{0} to {0}, its width, not {1}",
                             foam_.domain.width,
                             foam_.domain.shear));
        }
    }

    void read_junction(const JsonTree& item) {
        const JsonTree::Array& values = row(item, 3);
        const Vec2 position(number(values[0]), number(values[1]));
        if (!foam_.domain.is_plane() && !(is_inside(position.x(), foam_.domain.width) &&
                                          is_inside(position.y(), foam_.domain.height))) {
            fail(item.line,
                 fmt::format(
                     "junction at ({}, {}) is outside of the torus", position.x(), position.y()));
        }
        foam_.network.add_junction();
        foam_.positions.push_back(position);
    }

    static bool is_inside(double coordinate, double period) {
        return coordinate >= -kCellSlack * period && coordinate < (1.0 + kCellSlack) * period;
    }

    void count_films_and_bubbles() {
        films_ = array(member("films")).size();
        bubbles_ = array(member("bubbles")).size();
        if (films_ > std::numeric_limits<std::int32_t>::max() / 2) {
            fail(member("films").line, fmt::format("{} films are too many", films_));
        }
    }

    void read_film(const JsonTree& item) {
        const JsonTree::Array& values = row(item, 9);
        const std::size_t junctions = foam_.network.junction_slots();
        const HalfEdgeId h = forward_side(foam_.network.add_film());
        foam_.network.set_tail(h, id_at<JunctionId>(index(values[0], junctions)));
        foam_.network.set_tail(twin(h), id_at<JunctionId>(index(values[1], junctions)));
        const std::size_t regions = bubbles_ + (foam_.domain.is_plane() ? 1 : 0);  // with the ghost
        foam_.network.set_left(h, id_at<BubbleId>(index(values[2], regions)));
        foam_.network.set_left(twin(h), id_at<BubbleId>(index(values[3], regions)));
        foam_.network.set_next(h, half_edge(values[4]));
        foam_.network.set_next(twin(h), half_edge(values[5]));
        foam_.network.set_offset(h, {periods(values[6]), periods(values[7])});
        foam_.t1_armed.push_back(static_cast<std::uint8_t>(index(values[8], 2)));
    }

    std::int32_t periods(const JsonTree& value) const {
        constexpr double kMaxPeriods = 1e6;
        return static_cast<std::int32_t>(integer(value, -kMaxPeriods, kMaxPeriods));
    }

    void read_bubble(const JsonTree& item) {
        const JsonTree::Array& values = row(item, 5);
        const BubbleId bubble = foam_.network.add_bubble();
        foam_.identities.push_back(identity_in(values[0]));
        foam_.pressures.push_back(number(values[1]));
        foam_.target_areas.push_back(positive(values[2]));
        foam_.network.set_first(bubble, half_edge(values[3]));
        foam_.network.set_sides(bubble, static_cast<int>(index(values[4], 2 * films_ + 1)));
    }

    BubbleIdentity identity_in(const JsonTree& value) {
        const BubbleIdentity identity = index(value, foam_.next_identity);
        if (!identities_.insert(identity).second) {
            fail(value.line, fmt::format("duplicate bubble identity {}", identity));
        }
        return identity;
    }

    void read_patch() {
        const JsonTree::Array& ghost_row = row(member("ghost"), 2);
        const BubbleId ghost = foam_.network.add_ghost();
        const auto sides = static_cast<int>(index(ghost_row[1], 2 * films_ + 1));
        foam_.network.set_sides(ghost, sides);
        foam_.network.set_first(ghost, sides > 0 ? half_edge(ghost_row[0]) : kNone<HalfEdgeId>);
        complete_patch(foam_);
        const JsonTree::Array& angles = row(member("half_angles"), films_);
        for (const FilmId film : foam_.network.films()) {
            foam_.half_angles[film] = half_angle(angles[index_of(film)]);
        }
        for (const JsonTree& item : array(member("lone_bubbles"))) {
            const JsonTree::Array& values = row(item, 4);
            foam_.lone_bubbles.push_back({identity_in(values[0]),
                                          {number(values[1]), number(values[2])},
                                          positive(values[3])});
        }
    }

    double half_angle(const JsonTree& value) const {
        const double angle = number(value);
        if (!(std::abs(angle) < std::numbers::pi)) {
            fail(value.line, fmt::format("expected an angle between -pi and pi, found {}", angle));
        }
        return angle;
    }

    // Sets the outgoing half-edge of each junction to the one in the file. It must be set last,
    // because set_tail in read_film also sets it.
    void set_outgoing() {
        const JsonTree::Array& rows = array(member("junctions"));
        for (const JunctionId junction : foam_.network.junctions()) {
            const JsonTree& item = rows[index_of(junction)];
            const HalfEdgeId h = half_edge(row(item, 3)[2]);
            if (foam_.network.tail(h) != junction) {
                fail(item.line,
                     fmt::format("half-edge {} does not leave junction {}",
                                 index_of(h),
                                 index_of(junction)));
            }
            foam_.network.set_tail(h, junction);
        }
    }

    void check_foam() const {
        if (films_ == 0 && foam_.lone_bubbles.empty()) {
            fail(member("films").line, "the foam has no films and no lone bubbles");
        }
        if (const auto fault = find_fault(foam_.network)) {
            fail(member("films").line, fmt::format("the foam is not valid: {}", *fault));
        }
        if (foam_.domain.is_plane()) {
            return;
        }
        double sum = 0.0;
        for (const BubbleId bubble : foam_.network.bubbles()) {
            sum += foam_.target_areas[bubble];
        }
        if (!(std::abs(sum / foam_.domain.area() - 1.0) < kAreaTolerance)) {
            fail(member("bubbles").line,
                 fmt::format("the target areas add up to {}, but the torus has an area of {}",
                             sum,
                             foam_.domain.area()));
        }
    }

    const JsonTree& root_;
    const std::string& file_;
    Foam foam_;
    std::size_t films_ = 0;
    std::size_t bubbles_ = 0;
    std::unordered_set<BubbleIdentity> identities_;
};

}  // namespace

Foam read_foam_json(std::string_view text, const std::string& file) {
    const JsonTree root = parse_json(text, file);
    return Reader(root, file).read();
}

}  // namespace foam
