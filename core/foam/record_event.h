// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// Appends an event at the present time to the events of the foam. The ghost is omitted from the
/// bubbles of the event.
void record_event(Foam& foam,
                  TopologyEventKind kind,
                  const Vec2& position,
                  const std::vector<BubbleId>& bubbles);

/// Appends the event of a T1 at a film. Precondition: the T1 has not changed the network yet.
void record_t1(Foam& foam, FilmId film);

}  // namespace foam
