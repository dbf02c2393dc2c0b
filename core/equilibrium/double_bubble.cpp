#include "core/equilibrium/double_bubble.h"

#include "core/network/split.h"

#include <cmath>
#include <numbers>

namespace foam {

namespace {

constexpr double kThird = 2.0 * std::numbers::pi / 3.0;  // 120 degrees
constexpr int kHalvings = 60;                            // of the range of beta, down to rounding

double segment(double half_angle) {
    return arc_shape(half_angle).segment;
}

// Four times the areas over the chord squared.
double small_area(double beta) {
    return segment(kThird - beta) + segment(beta);
}
double large_area(double beta) {
    return segment(kThird + beta) - segment(beta);
}

// 0 for equal bubbles, nearly 60 degrees for a tiny one on a large one.
double inner_half_angle(double ratio) {
    double low = 0.0;
    double high = 0.5 * kThird;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        (small_area(middle) > ratio * large_area(middle) ? low : high) = middle;
    }
    return low;
}

void set_chord(Foam& foam, HalfEdgeId h, double length) {
    const Vec2 d = chord(foam, h);
    const Vec2 direction = d == Vec2::Zero() ? Vec2(1.0, 0.0) : Vec2(d.normalized());
    Vec2& tail = foam.positions[foam.network.tail(h)];
    Vec2& head = foam.positions[foam.network.head(h)];
    const Vec2 middle = 0.5 * (tail + head);
    tail = middle - 0.5 * length * direction;
    head = middle + 0.5 * length * direction;
}

// Of the outer film of the bubble on the left of the film between the two.
void set_bubble(Foam& foam, HalfEdgeId inner, double half_angle, double chord_length) {
    const HalfEdgeId outer = foam.network.next(inner);
    set_half_angle(foam, outer, half_angle);
    foam.pressures[foam.network.left(inner)] =
        2.0 * foam.film_tension * std::sin(half_angle) / chord_length;
}

}  // namespace

bool is_inside_double_bubble(const Network& network, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    return can_split(network, film) && network.sides(network.left(h)) == 2 &&
           network.sides(network.right(h)) == 2;
}

void settle_double_bubble(Foam& foam, FilmId film) {
    HalfEdgeId h = forward_side(film);
    if (foam.target_areas[foam.network.left(h)] > foam.target_areas[foam.network.right(h)]) {
        h = twin(h);
    }
    const double small = foam.target_areas[foam.network.left(h)];
    const double large = foam.target_areas[foam.network.right(h)];
    const double beta = inner_half_angle(small / large);
    const double length = 2.0 * std::sqrt(small / small_area(beta));
    set_chord(foam, h, length);
    set_bubble(foam, h, kThird - beta, length);
    set_bubble(foam, twin(h), kThird + beta, length);
}

}  // namespace foam
