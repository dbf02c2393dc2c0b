#include "core/equilibrium/relaxation.h"

#include "core/equilibrium/moves.h"
#include "core/equilibrium/settle_short_films.h"
#include "core/foam/measure.h"
#include "core/geometry/film_energy.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace foam {

namespace {

constexpr int kSweepsPerUpdate = 10;  // of the pressures at which bubbles have their targets
constexpr double kLargestBend = 0.3;  // of a half angle in a sweep, radians
constexpr double kEmptyShare = 0.5;   // of its target, below which a bubble is filled after a T1
// Of a film against bending, of that of a straight one, and along the chord of an outer one.
constexpr double kLeastStiffness = 0.1;

// A bubble in the energy of E4: p + B (1 - A / A_target) / sqrt(A_target), where p is to become the
// pressure at which it has its target. The ghost is one without stiffness.
struct SoftBubble {
    double area = 0.0;  // within the arcs; kept up to date
    double pressure_at_target = 0.0;
    double slope = 0.0;  // taken down, per area
    double target = 0.0;

    double pressure() const { return pressure_at_target + slope * (target - area); }
};

struct Arc {
    double half_angle = 0.0;
    double sine = 0.0;
    double cosine = 1.0;
    ArcShape shape;
};

// How an arc pulls at the end of its chord c, in film tensions, while that moves. Inner arcs keep
// their half angles, so that their length c q and their segment c² h / 4 grow. Outer arcs keep
// their segments, else a bubble that hangs on a short chord would collapse: with c² h constant,
// d(c q)/dc = cos alpha and d(alpha)/dc = -h / (w c) (E3).
struct Pull {
    double tension = 0.0;    // along the chord
    double segment = 0.0;    // h, along the half-edge, where it grows with the chord
    double stiffness = 0.0;  // along the chord, times c
};

Arc arc_of(double half_angle) {
    return {half_angle, std::sin(half_angle), std::cos(half_angle), arc_shape(half_angle)};
}

// What a bubble lacks of its target within its chords lies in the segments of its outer films.
void bulge_outer_films(Foam& foam, BubbleId bubble) {
    std::vector<HalfEdgeId> outer;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        if (foam.network.is_outer(film_of(h))) {
            outer.push_back(h);
        }
    }
    const double missing = (foam.target_areas[bubble] - polygon_area(foam, bubble)) /
                           static_cast<double>(outer.size());
    for (const HalfEdgeId h : outer) {
        const double squared = chord(foam, h).squaredNorm();
        const double angle = squared > 0.0 ? half_angle_of_segment(4.0 * missing / squared) : 0.0;
        set_half_angle(foam, h, angle);
    }
}

class Relaxation {
  public:
    Relaxation(Foam& foam, Unknowns part, const RelaxationOptions& options)
        : foam_(foam),
          part_(std::move(part)),
          options_(options),
          bubbles_(foam.network.bubble_slots()),
          arcs_(foam.network.film_slots()) {}

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
                keep_pressures();
            }
            summary.t1 += settle();
        }
        publish_pressures();
        wrap(foam_, part_);
        return summary;
    }

  private:
    bool is_free(BubbleId bubble) const {
        return foam_.network.is_live(bubble) && bubble != foam_.network.ghost();
    }

    void begin() {
        if (options_.begins_anew) {
            begin_anew();
        }
        for (const FilmId film : part_.films) {
            const HalfEdgeId h = forward_side(film);
            load(foam_.network.left(h));
            load(foam_.network.right(h));
        }
    }

    // Inner films straight, pressures at about those of equilibrium.
    void begin_anew() {
        const double pressure = work_per_area();
        for (const BubbleId bubble : part_.bubbles) {
            bulge_outer_films(foam_, bubble);
            foam_.pressures[bubble] = pressure;
        }
    }

    // In equilibrium the energy is 2 sum p A.
    double work_per_area() const {
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

    // Once each, those around the part, too: its junctions feel their pressures.
    void load(BubbleId bubble) {
        if (!is_free(bubble) || bubbles_[bubble].target > 0.0) {
            return;
        }
        const double target = foam_.target_areas[bubble];
        const double slope = options_.stiffness * foam_.film_tension / (target * std::sqrt(target));
        bubbles_[bubble] = {0.0, foam_.pressures[bubble], slope, target};
        for (const HalfEdgeId h : foam_.network.around(bubble)) {
            take_arc(film_of(h));
        }
        measure(bubble);
    }

    // The arc that the film has by the foam's pressures or, an outer one, by its half angle.
    void take_arc(FilmId film) {
        arcs_[film] = arc_of(film_arc(foam_, forward_side(film)).half_angle);
    }

    void measure(BubbleId bubble) {
        double area = polygon_area(foam_, bubble);
        for (const HalfEdgeId h : foam_.network.around(bubble)) {
            area += 0.25 * segment_of(h) * chord(foam_, h).squaredNorm();
        }
        bubbles_[bubble].area = area;
    }

    double pressure(BubbleId bubble) const { return bubbles_[bubble].pressure(); }

    // ArcShape::segment along the half-edge.
    double segment_of(HalfEdgeId h) const {
        const double segment = arcs_[film_of(h)].shape.segment;
        return is_forward(h) ? segment : -segment;
    }

    void move(JunctionId junction) {
        const std::array<HalfEdgeId, 3> leaving = foam_.network.leaving(junction);
        std::array<Vec2, 3> chords;
        for (std::size_t k = 0; k < 3; ++k) {
            chords[k] = chord(foam_, leaving[k]);
        }
        Vec2 step = newton_step(leaving, chords);
        double share = 1.0;
        for (const Vec2& d : chords) {
            share = std::min(share, allowed_share(d, -step, options_.largest_move));
        }
        step *= share;
        foam_.positions[junction] += step;
        for (std::size_t k = 0; k < 3; ++k) {
            bubbles_[foam_.network.left(leaving[k])].area -=
                0.5 * turned_left(chords[k] - chords[(k + 2) % 3]).dot(step);
            follow(film_of(leaving[k]), chords[k].squaredNorm(), (chords[k] - step).squaredNorm());
        }
    }

    Pull pull(HalfEdgeId h) const {
        const Arc& arc = arcs_[film_of(h)];
        if (foam_.network.is_outer(film_of(h))) {
            const double stiffness = arc.sine * arc.shape.segment / arc.shape.bulging;
            return {arc.cosine, 0.0, std::max(stiffness, kLeastStiffness)};
        }
        return {arc.shape.length, segment_of(h), 0.0};
    }

    Vec2 newton_step(const std::array<HalfEdgeId, 3>& leaving,
                     const std::array<Vec2, 3>& chords) const {
        const std::array<Pull, 3> pulls{pull(leaving[0]), pull(leaving[1]), pull(leaving[2])};
        Vec2 force = Vec2::Zero();
        Mat2 stiffness = Mat2::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t before = (k + 2) % 3;  // the film on the other side of the bubble
            const SoftBubble& bubble = bubbles_[foam_.network.left(leaving[k])];
            const Vec2 growth = -0.5 * turned_left(chords[k] - chords[before]) -
                                0.5 * pulls[k].segment * chords[k] +
                                0.5 * pulls[before].segment * chords[before];
            force += bubble.pressure() * growth;
            stiffness += bubble.slope * growth * growth.transpose();
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

    // The arc of a film whose squared chord has changed.
    void follow(FilmId film, double before, double after) {
        const double h = arcs_[film].shape.segment;
        const double angle = foam_.network.is_outer(film) && after > 0.0
                                 ? half_angle_of_segment(h * before / after)
                                 : arcs_[film].half_angle;
        set_arc(film, angle, before, after);
    }

    void set_arc(FilmId film, double angle, double squared_before, double squared_after) {
        const HalfEdgeId h = forward_side(film);
        const double before = squared_before * arcs_[film].shape.segment;
        if (angle != arcs_[film].half_angle) {
            bend_to(film, angle);
        }
        const double area = 0.25 * (squared_after * arcs_[film].shape.segment - before);
        bubbles_[foam_.network.left(h)].area += area;
        bubbles_[foam_.network.right(h)].area -= area;
    }

    // The half angle of an outer film is the foam's own.
    void bend_to(FilmId film, double angle) {
        if (foam_.network.is_outer(film)) {
            set_half_angle(foam_, forward_side(film), angle);
            arcs_[film] = arc_of(foam_.half_angles[film]);
        } else {
            arcs_[film] = arc_of(angle);
        }
    }

    // A Newton step of the half angle, with the junctions held.
    void bend(FilmId film) {
        const HalfEdgeId h = forward_side(film);
        const SoftBubble& left = bubbles_[foam_.network.left(h)];
        const SoftBubble& right = bubbles_[foam_.network.right(h)];
        const double squared = chord(foam_, h).squaredNorm();
        if (squared == 0.0) {
            return;
        }
        const Arc& arc = arcs_[film];
        const double growth = 0.5 * squared * arc.shape.bulging;
        const double tension = foam_.film_tension * std::sqrt(squared) * arc.shape.bulging;
        const double force = growth * (left.pressure() - right.pressure()) - tension * arc.sine;
        const double stiffness = tension * std::max(arc.cosine, kLeastStiffness) +
                                 growth * growth * (left.slope + right.slope);
        const double step = std::clamp(force / stiffness, -kLargestBend, kLargestBend);
        set_arc(film, held(film, arc.half_angle + step), squared, squared);
    }

    double held(FilmId film, double angle) const {
        static const double largest = std::asin(kLargestSine);
        return foam_.network.is_outer(film) ? angle : std::clamp(angle, -largest, largest);
    }

    void keep_pressures() {
        for (const BubbleId bubble : part_.bubbles) {
            bubbles_[bubble].pressure_at_target = pressure(bubble);
        }
    }

    void publish_pressures() {
        for (const BubbleId bubble : part_.bubbles) {
            foam_.pressures[bubble] = pressure(bubble);
        }
    }

    int settle() {
        publish_pressures();
        const auto renew = [this](FilmId film, const FourBubbles& around, bool changed) {
            renew_around(film, around, changed);
        };
        const int changes =
            settle_short_films(foam_, part_, options_.thresholds, Tangents::OfArcs, renew);
        rearm_grown_films(foam_, part_.films, options_.thresholds);
        return changes;
    }

    void renew_around(FilmId film, const FourBubbles& around, bool changed) {
        if (foam_.network.is_live(film)) {
            take_arc(film);
        }
        for (const BubbleId bubble : around) {
            if (is_free(bubble)) {
                renew(bubble, changed);
            }
        }
    }

    // A film that tears may leave a bubble next to nothing.
    void renew(BubbleId bubble, bool changed) {
        take_outer_arcs(bubble);
        measure(bubble);
        if (changed && bubbles_[bubble].area < kEmptyShare * bubbles_[bubble].target) {
            bulge_outer_films(foam_, bubble);
            take_outer_arcs(bubble);
            measure(bubble);
        }
    }

    // Where films have been joined, that of the kept one has changed.
    void take_outer_arcs(BubbleId bubble) {
        for (const HalfEdgeId h : foam_.network.around(bubble)) {
            if (foam_.network.is_outer(film_of(h))) {
                take_arc(film_of(h));
            }
        }
    }

    Foam& foam_;
    Unknowns part_;
    const RelaxationOptions& options_;
    Indexed<BubbleId, SoftBubble> bubbles_;
    Indexed<FilmId, Arc> arcs_;  // along forward sides
};

}  // namespace

RelaxationSummary relax(Foam& foam, const RelaxationOptions& options) {
    return relax(foam, all_unknowns(foam.network), options);
}

RelaxationSummary relax(Foam& foam, Unknowns part, const RelaxationOptions& options) {
    return Relaxation(foam, std::move(part), options).run();
}

}  // namespace foam
