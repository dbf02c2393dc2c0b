// SPDX-License-Identifier: Apache-2.0

#include "core/library/foam_records.h"

#include "core/foam/bubble_shape.h"
#include "core/foam/measure.h"

#include <vector>

namespace foam {

namespace {

using foamtex::Bubble;
using foamtex::Film;
using foamtex::FoamRecords;
using foamtex::Point;

// Returns the index of a bubble among the records, or -1 for the ghost.
std::int64_t bubble_index(const Frame& frame, BubbleId bubble) {
    return bubble == frame.network.ghost() ? -1 : static_cast<std::int64_t>(index_of(bubble));
}

Film film_record(const Frame& frame, FilmId film) {
    const Network& network = frame.network;
    const HalfEdgeId side = forward_side(film);
    const Vec2& tail = frame.positions[network.tail(side)];
    const FilmArc& arc = frame.arcs[film];
    return {.left = bubble_index(frame, network.left(side)),
            .right = bubble_index(frame, network.right(side)),
            .tail = static_cast<std::int64_t>(index_of(network.tail(side))),
            .head = static_cast<std::int64_t>(index_of(network.head(side))),
            .x = tail.x(),
            .y = tail.y(),
            .chord_x = arc.chord.x(),
            .chord_y = arc.chord.y(),
            .half_angle = arc.half_angle,
            .length = arc_length(arc)};
}

Bubble bubble_record(const FrameBubble& values, int sides, const BubbleShape& shape) {
    return {.identity = values.identity,
            .sides = sides,
            .x = shape.center.x(),
            .y = shape.center.y(),
            .area = values.area,
            .target_area = values.target_area,
            .pressure = values.pressure,
            .perimeter = shape.perimeter,
            .elongation = shape.elongation,
            .orientation = shape.orientation};
}

Bubble lone_record(const LoneBubble& bubble, double film_tension) {
    const double pressure = lone_pressure(bubble, film_tension);
    return bubble_record({bubble.identity, bubble.target_area, bubble.target_area, pressure},
                         0,
                         bubble_shape(bubble));
}

foamtex::EventKind kind_of(TopologyEventKind kind) {
    switch (kind) {
        case TopologyEventKind::T1:
            return foamtex::EventKind::T1;
        case TopologyEventKind::T2:
            return foamtex::EventKind::T2;
        default:
            return foamtex::EventKind::Birth;
    }
}

}  // namespace

std::vector<Bubble> bubble_records(const Frame& frame) {
    std::vector<Bubble> records;
    for (const BubbleId bubble : frame.network.bubbles()) {
        records.push_back(bubble_record(
            frame.bubbles[bubble], frame.network.sides(bubble), bubble_shape(frame, bubble)));
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        records.push_back(lone_record(bubble, frame.film_tension));
    }
    return records;
}

FoamRecords records_of(const Frame& frame) {
    FoamRecords records;
    records.bubbles = bubble_records(frame);
    for (const FilmId film : frame.network.films()) {
        records.films.push_back(film_record(frame, film));
    }
    for (const JunctionId junction : frame.network.junctions()) {
        const Vec2& position = frame.positions[junction];
        records.junctions.push_back({position.x(), position.y()});
    }
    return records;
}

foamtex::Extent extent_of(const Domain& domain) {
    return {domain.width, domain.height, domain.shear};
}

foamtex::Stress stress_record(const Mat2& stress) {
    return {stress(0, 0), stress(0, 1), stress(1, 1)};
}

std::vector<foamtex::Event> event_records(const std::vector<TopologyEvent>& events) {
    std::vector<foamtex::Event> records;
    records.reserve(events.size());
    for (const TopologyEvent& event : events) {
        records.push_back({.kind = kind_of(event.kind),
                           .time = event.time,
                           .position = {event.position.x(), event.position.y()},
                           .bubbles = {event.bubbles.begin(), event.bubbles.end()}});
    }
    return records;
}

}  // namespace foam
