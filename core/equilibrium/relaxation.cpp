#include "core/equilibrium/relaxation.h"

#include "core/equilibrium/moves.h"
#include "core/equilibrium/patch_relaxation.h"
#include "core/equilibrium/settle_short_films.h"
#include "core/foam/measure.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace foam {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFewestSides = 3;  // a bubble of two straight films has no area

// Straight films misjudge bubbles of few sides: in equilibrium a regular bubble of n sides has arcs
// of half angle pi/n - pi/6. This is the share of its area within the chords ...
double chord_share(int sides) {
    const double n = std::max(sides, kFewestSides);
    return 1.0 / (1.0 + std::tan(kPi / n) * segment_shape(std::sin(kPi / n - kPi / 6.0)));
}

// ... and this the pressure of its arcs over the pressure at which its straight films balance.
double arc_pressure_ratio(int sides) {
    const double n = std::max(sides, kFewestSides);
    if (sides == 6) {
        return 1.0;
    }
    return 2.0 * std::sin(kPi / n - kPi / 6.0) * std::cos(kPi / n) /
           (2.0 * std::sin(kPi / n) - 1.0);
}

// A bubble in the energy of E4: its pressure is B (1 - A / A_target) / sqrt(A_target), for the
// areas within the chords.
struct SoftBubble {
    double area = 0.0;              // kept up to date
    double pressure_at_zero = 0.0;  // of the area
    double pressure_slope = 0.0;    // taken down, per area

    double pressure() const { return pressure_at_zero - pressure_slope * area; }
};

struct SoftBubbles {
    Indexed<BubbleId, SoftBubble> each;
    double stiffness = 0.0;  // B

    // After a change of the bubble's sides, or to get rid of rounding.
    void refresh(const Foam& foam, BubbleId bubble) {
        const double target = foam.target_areas[bubble] * chord_share(foam.network.sides(bubble));
        const double at_zero = stiffness / std::sqrt(target);
        each[bubble] = {polygon_area(foam, bubble), at_zero, at_zero / target};
    }
};

// What moves a junction: its films, and how each of its bubbles' areas grows with its position.
struct Surroundings {
    std::array<HalfEdgeId, 3> leaving;
    std::array<Vec2, 3> chords;
    std::array<Vec2, 3> area_gradients;  // of the bubble on the left of each
};

Surroundings surroundings(const Foam& foam, JunctionId junction) {
    Surroundings s{foam.network.leaving(junction), {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        s.chords[k] = chord(foam, s.leaving[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        s.area_gradients[k] = -0.5 * turned_left(s.chords[k] - s.chords[(k + 2) % 3]);
    }
    return s;
}

Vec2 newton_step(const Foam& foam, const SoftBubbles& bubbles, const Surroundings& s) {
    Vec2 force = Vec2::Zero();
    Mat2 stiffness = Mat2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const SoftBubble& bubble = bubbles.each[foam.network.left(s.leaving[k])];
        const Vec2& growth = s.area_gradients[k];
        force += bubble.pressure() * growth;
        stiffness += bubble.pressure_slope * growth * growth.transpose();
        const double c = s.chords[k].norm();
        if (c > 0.0) {
            const Vec2 u = s.chords[k] / c;
            const Vec2 n = turned_left(u);
            force += foam.film_tension * u;
            stiffness += foam.film_tension / c * n * n.transpose();
        }
    }
    const double determinant = stiffness.determinant();
    return determinant > 0.0 ? Vec2(stiffness.inverse() * force) : force;
}

bool is_lens(const Foam& foam, BubbleId bubble) {
    return foam.network.sides(bubble) == 2;
}

bool touches_lens(const Foam& foam, JunctionId junction) {
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    return std::any_of(leaving.begin(), leaving.end(), [&](HalfEdgeId h) {
        return is_lens(foam, foam.network.left(h));
    });
}

// Straight films leave a two-sided bubble no area. Its junctions are set apart as on a straight
// film, where its arcs have half angles of 60 degrees, and held.
void fit_lens(Foam& foam, BubbleId bubble) {
    const HalfEdgeId h = foam.network.first(bubble);
    const Vec2 d = chord(foam, h);
    const double length =
        std::sqrt(2.0 * foam.target_areas[bubble] / segment_shape(std::sin(kPi / 3.0)));
    const Vec2 change = d == Vec2::Zero() ? Vec2(0.0, 0.0) : Vec2((length / d.norm() - 1.0) * d);
    foam.positions[foam.network.tail(h)] -= 0.5 * change;
    foam.positions[foam.network.head(h)] += 0.5 * change;
}

double lens_excess_pressure(const Foam& foam, BubbleId bubble) {
    const double length = chord(foam, foam.network.first(bubble)).norm();
    return length > 0.0 ? 2.0 * foam.film_tension * std::sin(kPi / 3.0) / length : 0.0;
}

void move_junction(Foam& foam, SoftBubbles& bubbles, JunctionId junction, double largest_move) {
    if (touches_lens(foam, junction)) {
        return;
    }
    const Surroundings s = surroundings(foam, junction);
    Vec2 step = newton_step(foam, bubbles, s);
    double share = 1.0;
    for (const Vec2& d : s.chords) {
        share = std::min(share, allowed_share(d, -step, largest_move));
    }
    step *= share;
    for (std::size_t k = 0; k < 3; ++k) {
        bubbles.each[foam.network.left(s.leaving[k])].area += s.area_gradients[k].dot(step);
    }
    foam.positions[junction] += step;
}

double mean_pressure_around(const Foam& foam, BubbleId bubble) {
    double sum = 0.0;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        sum += foam.pressures[foam.network.right(h)];
    }
    return sum / foam.network.sides(bubble);
}

// All bubbles whose pressures the part's junctions feel.
void refresh_all(const Foam& foam, const Unknowns& part, SoftBubbles& bubbles) {
    for (const BubbleId bubble : part.bubbles) {
        bubbles.refresh(foam, bubble);
    }
    for (const JunctionId junction : part.junctions) {
        for (const HalfEdgeId h : foam.network.leaving(junction)) {
            const BubbleId bubble = foam.network.left(h);
            if (part.bubble_rank[bubble] < 0) {
                bubbles.refresh(foam, bubble);
            }
        }
    }
}

// The pressures of the straight films, their excess over the neighbours turned into that of arcs.
std::vector<double> arc_pressures(const Foam& foam, const Unknowns& part) {
    std::vector<double> pressures;
    pressures.reserve(part.bubbles.size());
    for (const BubbleId bubble : part.bubbles) {
        const double around = mean_pressure_around(foam, bubble);
        const double excess =
            arc_pressure_ratio(foam.network.sides(bubble)) * (foam.pressures[bubble] - around);
        pressures.push_back(around +
                            (is_lens(foam, bubble) ? lens_excess_pressure(foam, bubble) : excess));
    }
    return pressures;
}

double mean_pressure(const Foam& foam, const Unknowns& part) {
    double sum = 0.0;
    for (const BubbleId bubble : part.bubbles) {
        sum += foam.pressures[bubble];
    }
    return sum / static_cast<double>(part.bubbles.size());
}

void set_pressures(Foam& foam, const Unknowns& part, SoftBubbles& bubbles) {
    const bool is_whole = part.bubbles.size() == foam.network.bubble_count();
    const double before = is_whole ? 0.0 : mean_pressure(foam, part);
    double straight = 0.0;
    for (const BubbleId bubble : part.bubbles) {
        bubbles.refresh(foam, bubble);
        straight += bubbles.each[bubble].pressure();
    }
    const double shift =
        is_whole ? 0.0 : before - straight / static_cast<double>(part.bubbles.size());
    for (const BubbleId bubble : part.bubbles) {
        foam.pressures[bubble] = bubbles.each[bubble].pressure() + shift;
    }
    const std::vector<double> pressures = arc_pressures(foam, part);
    for (std::size_t k = 0; k < pressures.size(); ++k) {
        foam.pressures[part.bubbles[k]] = pressures[k];
    }
}

}  // namespace

RelaxationSummary relax(Foam& foam, const RelaxationOptions& options) {
    return relax(foam, all_unknowns(foam.network), options);
}

RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options) {
    if (foam.network.ghost() != kNone<BubbleId>) {
        return relax_patch(foam, std::move(part), options);
    }
    RelaxationSummary summary;
    SoftBubbles bubbles{Indexed<BubbleId, SoftBubble>(foam.network.bubble_slots(), SoftBubble{}),
                        options.stiffness * foam.film_tension};
    for (const BubbleId bubble : part.bubbles) {
        if (is_lens(foam, bubble)) {
            fit_lens(foam, bubble);
        }
    }
    refresh_all(foam, part, bubbles);
    for (; summary.sweeps < options.sweeps; ++summary.sweeps) {
        for (const JunctionId junction : part.junctions) {
            move_junction(foam, bubbles, junction, options.largest_move);
        }
        summary.t1 += settle_short_films(foam,
                                         part,
                                         options.thresholds,
                                         Tangents::OfChords,
                                         [&](FilmId, const FourBubbles& around, bool) {
                                             for (const BubbleId bubble : around) {
                                                 bubbles.refresh(foam, bubble);
                                             }
                                         });
        rearm_grown_films(foam, part.films, options.thresholds);
    }
    set_pressures(foam, part, bubbles);
    wrap(foam, part);
    return summary;
}

}  // namespace foam
