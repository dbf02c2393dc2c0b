// SPDX-License-Identifier: Apache-2.0

#include "tests/support/raster_reference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace foam::test {

namespace {

// A periodic copy of a film, in pixels. A straight film is given by its chord. Any other film is
// given by the center of its circle and the range of directions from the center.
struct FilmCopy {
    Vec2 tail;
    Vec2 chord;
    bool straight;
    Vec2 center;
    double radius;
    double middle_direction;
    double half_range;
    bool turns_left;
    BubbleId left;
    BubbleId right;
};

using Nearest = NearestFilms::Nearest;

// Returns a copy of a film. All lengths are in pixels.
FilmCopy film_copy(const Vec2& tail, const FilmArc& arc, BubbleId left, BubbleId right) {
    FilmCopy copy{};
    copy.tail = tail;
    copy.chord = arc.chord;
    copy.left = left;
    copy.right = right;
    copy.straight = std::abs(arc.half_angle) < 1e-7;
    if (!copy.straight) {
        const Vec2 to_center = turned_left(arc.chord).normalized() *
                               (0.5 * copy.chord.norm() / std::tan(arc.half_angle));
        copy.center = copy.tail + 0.5 * copy.chord + to_center;
        copy.radius = 0.5 * copy.chord.norm() / std::sin(std::abs(arc.half_angle));
        copy.turns_left = arc.half_angle > 0.0;
        const Vec2 outwards = (copy.turns_left ? -1.0 : 1.0) * turned_left(arc.chord);
        copy.middle_direction = std::atan2(outwards.y(), outwards.x());
        copy.half_range = std::abs(arc.half_angle);
    }
    return copy;
}

// Returns a copy of a film in pixels, translated by `translation` (foam units). `scale` is in
// pixels per foam unit.
FilmCopy film_copy(const Frame& frame, FilmId film, double scale, const Vec2& translation) {
    const HalfEdgeId h = forward_side(film);
    const FilmArc& arc = frame.arcs[film];
    return film_copy(scale * (frame.positions[frame.network.tail(h)] + translation),
                     {scale * arc.chord, arc.half_angle},
                     frame.network.left(h),
                     frame.network.right(h));
}

Nearest to_ends(const FilmCopy& film, const Vec2& point) {
    const double distance =
        std::min((point - film.tail).norm(), (point - film.tail - film.chord).norm());
    return {distance, film.left};
}

Nearest to_straight(const FilmCopy& film, const Vec2& point) {
    const double along = (point - film.tail).dot(film.chord) / film.chord.squaredNorm();
    if (along < 0.0 || along > 1.0) {
        return to_ends(film, point);
    }
    const double left = cross(film.chord, point - film.tail) / film.chord.norm();
    return {std::abs(left), left > 0.0 ? film.left : film.right};
}

Nearest to_film(const FilmCopy& film, const Vec2& point) {
    if (film.straight) {
        return to_straight(film, point);
    }
    const Vec2 out = point - film.center;
    const double away = std::remainder(std::atan2(out.y(), out.x()) - film.middle_direction,
                                       2.0 * std::numbers::pi);
    if (std::abs(away) > film.half_range) {
        return to_ends(film, point);
    }
    const bool inside = out.norm() < film.radius;
    return {std::abs(out.norm() - film.radius), inside == film.turns_left ? film.left : film.right};
}

std::vector<FilmCopy> all_copies(const Frame& frame, double scale) {
    std::vector<FilmCopy> copies;
    for (const FilmId film : frame.network.films()) {
        for (int i = -2; i <= 2; ++i) {
            for (int j = -2; j <= 2; ++j) {
                copies.push_back(film_copy(frame, film, scale, frame.domain.translation({i, j})));
            }
        }
    }
    return copies;
}

// Returns the films of a patch. Each lone bubble has two films, which are half circles.
std::vector<FilmCopy> all_films(const Frame& frame, double scale, const Vec2& translation) {
    std::vector<FilmCopy> films;
    for (const FilmId film : frame.network.films()) {
        films.push_back(film_copy(frame, film, scale, translation));
    }
    for (std::size_t k = 0; k < frame.lone_bubbles.size(); ++k) {
        const LoneBubble& bubble = frame.lone_bubbles[k];
        const auto id = id_at<BubbleId>(frame.network.bubble_slots() + k);
        const Vec2 center = scale * (bubble.center + translation);
        const Vec2 radius(scale * std::sqrt(bubble.target_area / std::numbers::pi), 0.0);
        for (const double side : {-1.0, 1.0}) {
            films.push_back(film_copy(center + side * radius,
                                      {-2.0 * side * radius, 0.5 * std::numbers::pi},
                                      id,
                                      frame.network.ghost()));
        }
    }
    return films;
}

// Returns the translation from positions in the foam to positions relative to the lower left corner
// of the image, in foam units.
Vec2 origin_of(const texgen::View& view, int width, int height) {
    return 0.5 / view.pixels_per_unit * Vec2(width, height) - view.center;
}

// Returns the films that can be the nearest film of some point of a pixel.
std::vector<FilmCopy> candidates(const std::vector<FilmCopy>& films, const Vec2& center) {
    constexpr double kPixelDiameter = std::numbers::sqrt2;
    double nearest_distance = std::numeric_limits<double>::infinity();
    for (const FilmCopy& film : films) {
        nearest_distance = std::min(nearest_distance, to_film(film, center).distance);
    }
    std::vector<FilmCopy> near;
    for (const FilmCopy& film : films) {
        if (to_film(film, center).distance <= nearest_distance + kPixelDiameter) {
            near.push_back(film);
        }
    }
    return near;
}

Nearest nearest(const std::vector<FilmCopy>& films, const Vec2& point) {
    Nearest best;
    for (const FilmCopy& film : films) {
        const Nearest here = to_film(film, point);
        best = here.distance < best.distance ? here : best;
    }
    return best;
}

constexpr int kLatticePoints = 17711;
constexpr int kLatticeGenerator = 10946;
constexpr int kGridSide = 64;

int sample_count(Samples samples) {
    return samples == Samples::Lattice ? kLatticePoints : kGridSide * kGridSide;
}

Vec2 sample_point(Samples samples, int k) {
    if (samples == Samples::Grid) {
        const int row = k / kGridSide;
        return Vec2(k % kGridSide + 0.5, row + 0.5) / kGridSide;
    }
    const std::int64_t step = std::int64_t{k} * kLatticeGenerator % kLatticePoints;
    return Vec2(k + 0.5, static_cast<double>(step) + 0.5) / kLatticePoints;
}

void sample_pixel(const std::vector<FilmCopy>& films,
                  const Vec2& corner,
                  double min_distance,
                  Samples kind,
                  std::vector<double>& parts) {
    constexpr double kPixelRadius = 0.5 * std::numbers::sqrt2;
    const Vec2 center = corner + Vec2(0.5, 0.5);
    const std::vector<FilmCopy> near = candidates(films, center);
    const Nearest at_center = nearest(near, center);
    const bool uniform = at_center.distance > kPixelRadius &&
                         std::abs(at_center.distance - min_distance) > kPixelRadius;
    const int samples = uniform ? 1 : sample_count(kind);
    for (int k = 0; k < samples; ++k) {
        const Vec2 at = uniform ? center : Vec2(corner + sample_point(kind, k));
        const Nearest found = nearest(near, at);
        if (found.distance >= min_distance) {
            parts[index_of(found.bubble)] += 1.0 / samples;
        }
    }
}

SampledCoverage sample_films(const std::vector<FilmCopy>& films,
                             int width,
                             int height,
                             double film_width,
                             std::size_t bubbles,
                             Samples samples) {
    SampledCoverage coverage{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            coverage.parts.push_back(std::vector<double>(bubbles, 0.0));
            sample_pixel(films, Vec2(x, y), 0.5 * film_width, samples, coverage.parts.back());
        }
    }
    return coverage;
}

}  // namespace

SampledCoverage sample_coverage(
    const Frame& frame, int width, int height, double film_width, Samples samples) {
    return sample_films(all_copies(frame, width / frame.domain.width),
                        width,
                        height,
                        film_width,
                        frame.network.bubble_slots(),
                        samples);
}

SampledCoverage sample_coverage(
    const Frame& frame, const texgen::View& view, int width, int height, double film_width) {
    return sample_films(all_films(frame, view.pixels_per_unit, origin_of(view, width, height)),
                        width,
                        height,
                        film_width,
                        frame.network.bubble_slots() + frame.lone_bubbles.size(),
                        Samples::Lattice);
}

struct NearestFilms::Films {
    std::vector<FilmCopy> films;
};

NearestFilms::NearestFilms(const Frame& frame, int width)
    : films_(new Films{all_copies(frame, width / frame.domain.width)}) {}

NearestFilms::NearestFilms(const Frame& frame, const texgen::View& view, int width, int height)
    : films_(new Films{all_films(frame, view.pixels_per_unit, origin_of(view, width, height))}) {}

NearestFilms::~NearestFilms() = default;

NearestFilms::Nearest NearestFilms::at(const Vec2& pixel) const {
    return nearest(films_->films, pixel);
}

}  // namespace foam::test
