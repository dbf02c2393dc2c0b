// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze_line.h"

namespace foam::texgen {

namespace {

// The number of straight pieces that replace the curve between two successive points (Station) of
// the line.
constexpr int kPiecesPerCurve = 16;

// Returns the unit vector from the bubble on the left of a half-edge to the bubble on its right,
// perpendicular to the chord of the half-edge's arc.
Vec2 across(const FilmArc& arc) {
    return -turned_left(arc.chord).normalized();
}

// Returns the vector from the tail of one side of a bubble to the tail of another side of the same
// bubble.
Vec2 between_tails(const Frame& frame, HalfEdgeId from, HalfEdgeId to) {
    Vec2 sum(0.0, 0.0);
    for (; from != to; from = frame.network.next(from)) {
        sum += frame.arc(from).chord;
    }
    return sum;
}

// Returns the mean of the corners of the bubble on the left of a side, relative to the side's tail.
Vec2 mean_corner(const Frame& frame, HalfEdgeId side) {
    Vec2 sum(0.0, 0.0);
    Vec2 corner(0.0, 0.0);
    int count = 0;
    HalfEdgeId at = side;
    do {
        sum += corner;
        corner += frame.arc(at).chord;
        ++count;
        at = frame.network.next(at);
    } while (at != side);
    return sum / count;
}

// Returns a point of the cubic Hermite curve between two stations; `t` is from 0 to 1.
Vec2 point_of(const Station& a, const Station& b, double t) {
    const double length = (b.position - a.position).norm();
    const double u = 1.0 - t;
    return u * u * (1.0 + 2.0 * t) * a.position + t * t * (1.0 + 2.0 * u) * b.position +
           length * t * u * (u * a.direction - t * b.direction);
}

// Returns the derivative of point_of with respect to `t`.
Vec2 velocity_of(const Station& a, const Station& b, double t) {
    const Vec2 step = b.position - a.position;
    const double u = 1.0 - t;
    return 6.0 * t * u * step +
           step.norm() * (u * (1.0 - 3.0 * t) * a.direction + t * (3.0 * t - 2.0) * b.direction);
}

}  // namespace

std::vector<Station> solution_stations(const Frame& frame, std::span<const HalfEdgeId> path) {
    std::vector<Station> stations;
    Vec2 tail = frame.positions[frame.network.tail(path.front())];
    for (std::size_t k = 0; k < path.size(); ++k) {
        if (k > 0) {
            const HalfEdgeId entry = twin(path[k - 1]);
            tail += frame.arc(path[k - 1]).chord + between_tails(frame, entry, path[k]);
        }
        const FilmArc arc = frame.arc(path[k]);
        stations.push_back({tail + point_at(arc, 0.5), across(arc)});
    }
    if (!frame.domain.is_plane()) {
        const HalfEdgeId last = twin(path.back());
        const Vec2 end = tail + frame.arc(path.back()).chord + mean_corner(frame, last);
        const Vec2 start =
            frame.positions[frame.network.tail(path.front())] + mean_corner(frame, path.front());
        const Vec2 first_step = stations.front().position - start;
        const Vec2 last_step = end - stations.back().position;
        stations.insert(stations.begin(), {start, first_step.normalized()});
        stations.push_back({end, last_step.normalized()});
    }
    return stations;
}

std::vector<Station> refined(std::span<const Station> stations, int pieces) {
    std::vector<Station> fine{stations.front()};
    for (std::size_t k = 1; k < stations.size(); ++k) {
        for (int piece = 1; piece < pieces; ++piece) {
            const double t = static_cast<double>(piece) / pieces;
            fine.push_back({point_of(stations[k - 1], stations[k], t),
                            velocity_of(stations[k - 1], stations[k], t).normalized()});
        }
        fine.push_back(stations[k]);
    }
    return fine;
}

std::vector<PlacedArc> solution_line(const Frame& frame,
                                     std::span<const HalfEdgeId> path,
                                     double scale) {
    std::vector<PlacedArc> line;
    if (path.empty()) {
        return line;
    }
    const std::vector<Station> stations = solution_stations(frame, path);
    for (std::size_t k = 1; k < stations.size(); ++k) {
        Vec2 from = stations[k - 1].position;
        for (int piece = 1; piece <= kPiecesPerCurve; ++piece) {
            const double t = static_cast<double>(piece) / kPiecesPerCurve;
            const Vec2 to = point_of(stations[k - 1], stations[k], t);
            line.push_back({from, {scale * (to - from), 1.0, 0.0}});
            from = to;
        }
    }
    return line;
}

}  // namespace foam::texgen
