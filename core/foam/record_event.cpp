// SPDX-License-Identifier: Apache-2.0

#include "core/foam/record_event.h"

#include "core/network/t1.h"

#include <utility>

namespace foam {

void record_event(Foam& foam,
                  TopologyEventKind kind,
                  const Vec2& position,
                  const std::vector<BubbleId>& bubbles) {
    TopologyEvent event{kind, foam.time, position};
    for (const BubbleId bubble : bubbles) {
        if (bubble != foam.network.ghost()) {
            event.bubbles.push_back(foam.identities[bubble]);
        }
    }
    foam.events.push_back(std::move(event));
}

void record_t1(Foam& foam, FilmId film) {
    const T1Site site = t1_site(foam.network, film);
    record_event(foam,
                 TopologyEventKind::T1,
                 middle_of(foam, film),
                 {foam.network.left(site.film),
                  foam.network.right(site.film),
                  site.end_tail,
                  site.end_head});
}

}  // namespace foam
