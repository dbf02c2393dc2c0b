// SPDX-License-Identifier: Apache-2.0

#include "core/foam/frame.h"

#include "core/foam/measure.h"

#include <algorithm>
#include <cstdint>
namespace foam {

Frame snapshot(const Foam& foam, int number) {
    Foam dense = foam;
    compact(dense);
    Frame frame{number, dense.time, dense.domain, dense.film_tension, {}, {}, {}, {}, {}};
    for (const FilmId film : dense.network.films()) {
        frame.arcs.push_back(film_arc(dense, forward_side(film)));
    }
    const Indexed<BubbleId, double> areas = bubble_areas(dense);
    for (const BubbleId bubble : dense.network.bubbles()) {
        frame.bubbles.push_back({dense.identities[bubble],
                                 areas[bubble],
                                 dense.target_areas[bubble],
                                 dense.pressures[bubble]});
    }
    frame.network = std::move(dense.network);
    frame.positions = std::move(dense.positions);
    frame.lone_bubbles = std::move(dense.lone_bubbles);
    return frame;
}

Foam foam_of(const Frame& frame) {
    Foam foam;
    foam.domain = frame.domain;
    foam.film_tension = frame.film_tension;
    foam.time = frame.time;
    foam.network = frame.network;
    foam.positions = frame.positions;
    for (const FrameBubble& bubble : frame.bubbles) {
        foam.pressures.push_back(bubble.pressure);
        foam.target_areas.push_back(bubble.target_area);
        foam.identities.push_back(bubble.identity);
        foam.next_identity = std::max(foam.next_identity, bubble.identity + 1);
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        foam.next_identity = std::max(foam.next_identity, bubble.identity + 1);
    }
    foam.t1_armed = Indexed<FilmId, std::uint8_t>(frame.network.film_slots(), 1);
    foam.lone_bubbles = frame.lone_bubbles;
    if (frame.domain.is_plane()) {
        complete_patch(foam);
        for (const FilmId film : foam.network.films()) {
            if (foam.network.is_outer(film)) {
                set_half_angle(foam, forward_side(film), frame.arcs[film].half_angle);
            }
        }
    }
    return foam;
}

}  // namespace foam
