// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// Appends an event with the present foam time to Foam::events. The ghost is omitted from the
/// bubbles of the event.
void record_event(Foam& foam,
                  TopologyEventKind kind,
                  const Vec2& position,
                  const std::vector<BubbleId>& bubbles);

/// Appends the event of a T1 of a film. The position of the event is the midpoint of the film's
/// chord, and its bubbles are the four bubbles around the film. Precondition: the T1 has not
/// changed the network yet.
void record_t1(Foam& foam, FilmId film);

}  // namespace foam
