#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// Appends an event to those of the foam, at its present time. The ghost is left out of the
/// bubbles.
void note_event(Foam& foam,
                TopologyEventKind kind,
                const Vec2& place,
                const std::vector<BubbleId>& bubbles);

/// Appends a T1 at a film, before it is carried out.
void note_t1(Foam& foam, FilmId film);

}  // namespace foam
