// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/scene.h"

#include "core/foam/random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace foam::bench {

namespace {

constexpr double kSagitta = 1.0 / 32;  // largest distance of a polyline from its arc, pixels
constexpr int kScale16 = 257;          // factor from 8 bits to 16 bits

// Appends the vertices of a polyline along an arc, except the last vertex.
void append_line(const FilmArc& arc, const Vec2& tail, Polyline& line) {
    const double sagitta = 0.25 * arc_length(arc) * std::abs(arc.half_angle);
    const int edges = std::max(1, static_cast<int>(std::ceil(std::sqrt(sagitta / kSagitta))));
    for (int k = 0; k < edges; ++k) {
        line.emplace_back(tail + (k == 0 ? Vec2::Zero() : point_at(arc, double(k) / edges)));
    }
}

// Returns true if the line, widened by the film width on each side, may be visible in the image.
bool shows(const Polyline& line, int side) {
    Vec2 low = line.front();
    Vec2 high = low;
    for (const Vec2& point : line) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return low.maxCoeff() < side + kFilmWidth && high.minCoeff() > -kFilmWidth;
}

Polyline moved(Polyline line, const Vec2& by) {
    for (Vec2& point : line) {
        point += by;
    }
    return line;
}

// Identifies a lattice copy of a film: the film, and the lattice offset (i, j) of its tail.
using FilmCopy = std::tuple<FilmId, std::int32_t, std::int32_t>;

class SceneBuilder {
  public:
    SceneBuilder(const Frame& frame, int side)
        : frame_(frame), scale_(side / frame.domain.width), scene_{side, {}, {}, {}} {}

    Scene build() {
        for (const BubbleId bubble : frame_.network.bubbles()) {
            add_cell(bubble);
        }
        for (auto& [copy, film] : films_) {
            const auto& [id, i, j] = copy;
            draw_film(id, {i, j}, film.line);
            scene_.films.push_back(std::move(film));
        }
        Random random(1);
        for (std::size_t k = 0; k < frame_.bubbles.size(); ++k) {
            const auto level = [&] { return static_cast<std::uint8_t>(random.below(256)); };
            scene_.colors.push_back({level(), level(), level()});
        }
        return std::move(scene_);
    }

  private:
    FilmArc arc(HalfEdgeId h) const {
        const FilmArc in_units = frame_.arc(h);
        return {scale_ * in_units.chord, in_units.half_angle};
    }
    Vec2 tail(HalfEdgeId h, LatticeOffset copy) const {
        const Vec2& position = frame_.positions[frame_.network.tail(h)];
        return scale_ * (position + frame_.domain.translation(copy));
    }

    void add_cell(BubbleId bubble) {
        const Network& network = frame_.network;
        Polyline outline;
        std::vector<std::pair<HalfEdgeId, LatticeOffset>> sides;
        LatticeOffset unwrapping;
        for (const HalfEdgeId h : network.around(bubble)) {
            append_line(arc(h), tail(h, unwrapping), outline);
            sides.emplace_back(h, is_forward(h) ? unwrapping : unwrapping + network.offset(h));
            unwrapping = unwrapping + network.offset(h);
        }
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                Polyline copy = moved(outline, scene_.side * Vec2(i, j));
                if (!shows(copy, scene_.side)) {
                    continue;
                }
                scene_.cells.push_back({index_of(bubble), std::move(copy)});
                for (const auto& [h, offset] : sides) {
                    Scene::Film& film = films_[{film_of(h), offset.i + i, offset.j + j}];
                    (is_forward(h) ? film.left : film.right) = static_cast<int>(index_of(bubble));
                }
            }
        }
    }

    void draw_film(FilmId film, LatticeOffset copy, Polyline& line) const {
        const HalfEdgeId h = forward_side(film);
        append_line(arc(h), tail(h, copy), line);
        line.emplace_back(tail(h, copy) + arc(h).chord);
    }

    const Frame& frame_;
    double scale_;
    Scene scene_;
    std::map<FilmCopy, Scene::Film> films_;
};

}  // namespace

Scene scene_of(const Frame& frame, int side) {
    return SceneBuilder(frame, side).build();
}

texgen::CellValues values_of(const Scene& scene) {
    texgen::CellValues values{3, {}, {65535, 65535, 65535}};
    for (const auto& color : scene.colors) {
        for (const std::uint8_t level : color) {
            values.bubbles.push_back(static_cast<std::uint16_t>(level * kScale16));
        }
    }
    return values;
}

}  // namespace foam::bench
