// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/relaxation.h"

#include "core/equilibrium/flip_short_films.h"
#include "core/equilibrium/moves.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"
#include "core/geometry/elementary.h"
#include "core/geometry/film_energy.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace foam {

// Relaxation (E4) is a nonlinear Gauss-Seidel method (Ortega and Rheinboldt, Iterative Solution of
// Nonlinear Equations in Several Variables, 1970). A sweep makes a Newton step for each junction in
// turn, and then one for the half angle of each film in turn. All other unknowns are held during a
// step, except that the step of a junction also changes the half angles of its outer films. The
// areas of the adjacent bubbles are updated after each step. The pressure of a bubble is the sum of
// a multiplier of its area constraint and a penalty on its area error. After every kSweepsPerUpdate
// sweeps, the present pressure becomes the multiplier, so that the areas converge to their targets
// without a large stiffness. This is the method of multipliers (Hestenes 1969; Powell 1969; Nocedal
// and Wright, Numerical Optimization, 2006, chapter 17).

namespace {

constexpr int kSweepsPerUpdate = 10;  // sweeps between updates of the method of multipliers (E4)
constexpr double kMaxBend = 0.3;      // largest change of a half angle by a call of `bend`, radians
// Lower bound of cos alpha in the stiffness of a film against bending (`bend`), where alpha is the
// half angle. Also the lower bound of Pull::stiffness of an outer film.
constexpr double kMinStiffness = 0.1;

// Describes how an arc acts on one end of its chord in the Newton step of the junction at this end
// (`newton_step`). Tension and stiffness are divided by the film tension. The length of the chord
// is c; q, h and w are the functions of the half angle alpha in E3. Inner arcs keep their half
// angles, so that their length c q and the area of their segment, c² h / 4, grow with the chord.
// Outer arcs keep the area of their segments, since otherwise a bubble on a short chord would
// collapse. With c² h constant, d(c q)/dc = cos alpha and d(alpha)/dc = -h / (w c) (E3).
struct Pull {
    double tension = 0.0;  // along the chord
    // h of E3, positive if the arc adds to the area on the left of the half-edge; 0 if the segment
    // keeps its area.
    double segment = 0.0;
    double stiffness = 0.0;  // stiffness along the chord, times c
};

class Relaxation {
  public:
    Relaxation(Foam& foam, Unknowns part, const RelaxationOptions& options, SoftFoam& soft)
        : foam_(foam), part_(std::move(part)), options_(options), soft_(soft) {}

    RelaxationSummary run() {
        begin();
        RelaxationSummary summary;
        for (; summary.sweeps < options_.sweeps; ++summary.sweeps) {
            for (const JunctionId junction : part_.junctions) {
                move(junction);
            }
            for (const FilmId film : part_.films) {
                bend(film);
            }
            if ((summary.sweeps + 1) % kSweepsPerUpdate == 0) {
                update_multipliers();
            }
            summary.t1 += flip_short();
        }
        store_pressures();
        wrap(foam_, part_);
        return summary;
    }

  private:
    void begin() {
        if (options_.restarts) {
            restart();
        }
        soft_.begin(options_.stiffness);
        // Loads all bubbles beside the films of the part, including bubbles outside of the part.
        for (const FilmId film : part_.films) {
            soft_.load(foam_.network.left(forward_side(film)));
            soft_.load(foam_.network.right(forward_side(film)));
        }
    }

    // Resets the pressures to a common value near the pressures in equilibrium. As the value is
    // common, inner films become straight. Outer films get arcs that give their bubbles the target
    // areas.
    void restart() {
        const double pressure = mean_pressure();
        for (const BubbleId bubble : part_.bubbles) {
            bulge_outer_films(foam_, bubble);
            foam_.pressures[bubble] = pressure;
        }
    }

    // Returns an estimate of the pressures: the common pressure p for which T Σ c = 2 p Σ A. Here
    // the c are chord lengths and the A are target areas. In the equilibrium of a patch,
    // T Σ l = 2 Σ p A holds with arc lengths l and the pressure p of each bubble (E3).
    double mean_pressure() const {
        double length = 0.0;
        for (const FilmId film : part_.films) {
            length += chord(foam_, forward_side(film)).norm();
        }
        double area = 0.0;
        for (const BubbleId bubble : part_.bubbles) {
            area += foam_.target_areas[bubble];
        }
        return 0.5 * foam_.film_tension * length / area;
    }

    void move(JunctionId junction) {
        const std::array<HalfEdgeId, 3> leaving = foam_.network.leaving(junction);
        std::array<Vec2, 3> chords;
        for (std::size_t k = 0; k < 3; ++k) {
            chords[k] = chord(foam_, leaving[k]);
        }
        Vec2 step = newton_step(leaving, chords);
        double fraction = 1.0;
        for (const Vec2& d : chords) {
            fraction = std::min(fraction, allowed_fraction(d, -step, options_.largest_move));
        }
        step *= fraction;
        foam_.positions[junction] += step;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 across = 0.5 * turned_left(chords[k] - chords[(k + 2) % 3]);
            soft_.add_area(foam_.network.left(leaving[k]), -across.dot(step));
            update_arc(
                film_of(leaving[k]), chords[k].squaredNorm(), (chords[k] - step).squaredNorm());
        }
    }

    Pull pull(HalfEdgeId h) const {
        const SoftFoam::Arc& arc = soft_.arc(film_of(h));
        if (foam_.network.is_outer(film_of(h))) {
            const double stiffness = arc.sine * arc.shape.segment / arc.shape.bulging;
            return {arc.cosine, 0.0, std::max(stiffness, kMinStiffness)};
        }
        return {arc.shape.length, soft_.segment_of(h), 0.0};
    }

    // Returns the displacement of a junction by one Newton step. Returns the force instead if the
    // stiffness matrix is not positive definite.
    Vec2 newton_step(const std::array<HalfEdgeId, 3>& leaving,
                     const std::array<Vec2, 3>& chords) const {
        const std::array<Pull, 3> pulls{pull(leaving[0]), pull(leaving[1]), pull(leaving[2])};
        Vec2 force = Vec2::Zero();
        Mat2 stiffness = Mat2::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t other = (k + 2) % 3;  // the bubble's other film at the junction
            const BubbleId bubble = foam_.network.left(leaving[k]);
            // The gradient of the bubble's area with respect to the position of the junction.
            const Vec2 growth = -0.5 * turned_left(chords[k] - chords[other]) -
                                0.5 * pulls[k].segment * chords[k] +
                                0.5 * pulls[other].segment * chords[other];
            force += soft_.pressure(bubble) * growth;
            stiffness += soft_.slope(bubble) * growth * growth.transpose();
            const double c = chords[k].norm();
            if (c > 0.0) {
                const Vec2 u = chords[k] / c;
                const Vec2 n = turned_left(u);
                force += foam_.film_tension * pulls[k].tension * u;
                stiffness += foam_.film_tension / c *
                             (pulls[k].stiffness * u * u.transpose() +
                              std::abs(pulls[k].tension) * n * n.transpose());
            }
        }
        const double determinant = stiffness.determinant();
        return determinant > 0.0 ? Vec2(stiffness.inverse() * force) : force;
    }

    // Updates the arc of a film after a change of its squared chord length.
    void update_arc(FilmId film, double squared_before, double squared_after) {
        const SoftFoam::Arc& arc = soft_.arc(film);
        const double angle =
            foam_.network.is_outer(film) && squared_after > 0.0
                ? half_angle_of_segment(arc.shape.segment * squared_before / squared_after)
                : arc.half_angle;
        soft_.set_arc(film, angle, squared_before, squared_after);
    }

    // Makes a Newton step of the half angle of the film, with the junctions held. Does nothing if
    // the chord is zero.
    void bend(FilmId film) {
        const HalfEdgeId h = forward_side(film);
        const BubbleId left = foam_.network.left(h);
        const BubbleId right = foam_.network.right(h);
        const double squared = chord(foam_, h).squaredNorm();
        if (squared == 0.0) {
            return;
        }
        const SoftFoam::Arc& arc = soft_.arc(film);
        const double growth = 0.5 * squared * arc.shape.bulging;
        const double tension = foam_.film_tension * std::sqrt(squared) * arc.shape.bulging;
        const double force =
            growth * (soft_.pressure(left) - soft_.pressure(right)) - tension * arc.sine;
        const double stiffness = tension * std::max(arc.cosine, kMinStiffness) +
                                 growth * growth * (soft_.slope(left) + soft_.slope(right));
        const double step = std::clamp(force / stiffness, -kMaxBend, kMaxBend);
        soft_.set_arc(film, clamped(film, arc.half_angle + step), squared, squared);
    }

    double clamped(FilmId film, double angle) const {
        static const double largest = ieee::asin(kLargestSine);
        return foam_.network.is_outer(film) ? angle : std::clamp(angle, -largest, largest);
    }

    void update_multipliers() {
        for (const BubbleId bubble : part_.bubbles) {
            soft_.update_multiplier(bubble);
        }
    }

    void store_pressures() {
        for (const BubbleId bubble : part_.bubbles) {
            foam_.pressures[bubble] = soft_.pressure(bubble);
        }
    }

    int flip_short() {
        store_pressures();
        const auto renew = [this](FilmId film, const FourBubbles& around, bool changed) {
            renew_around(film, around, changed);
        };
        const int changes = flip_short_films(foam_, part_, options_.thresholds, renew);
        rearm_grown_films(foam_, part_.films, options_.thresholds);
        return changes;
    }

    void renew_around(FilmId film, const FourBubbles& around, bool changed) {
        if (foam_.network.is_live(film)) {
            soft_.load_arc(film);
        }
        for (const BubbleId bubble : around) {
            if (foam_.network.is_live(bubble) && bubble != foam_.network.ghost()) {
                soft_.renew(bubble, changed);
            }
        }
    }

    Foam& foam_;
    Unknowns part_;
    const RelaxationOptions& options_;
    SoftFoam& soft_;
};

}  // namespace

RelaxationSummary relax(Foam& foam, const RelaxationOptions& options) {
    return relax(foam, all_unknowns(foam.network), options);
}

RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options) {
    SoftFoam soft(foam);
    return relax(foam, std::move(part), options, soft);
}

RelaxationSummary relax(Foam& foam,
                        Unknowns part,
                        const RelaxationOptions& options,
                        SoftFoam& memory) {
    return Relaxation(foam, std::move(part), options, memory).run();
}

}  // namespace foam
