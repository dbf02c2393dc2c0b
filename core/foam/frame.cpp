// SPDX-License-Identifier: Apache-2.0

#include "core/foam/frame.h"

#include "core/foam/measure.h"

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

}  // namespace foam
