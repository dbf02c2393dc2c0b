// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/history.h"

#include "core/foam/frame.h"
#include "texgen/maps/bubble_pressure.h"

#include <algorithm>

namespace foam::texgen {

History::History(const Foam& foam) : time_(foam.time), domain_(foam.domain) {}

void History::record_events(Foam& foam, int frame) {
    shear_recorded_events(foam.domain);
    record_.births.resize(foam.next_identity, time_);
    record_.changes.resize(foam.next_identity, time_);
    for (const TopologyEvent& event : foam.events) {
        for (const BubbleIdentity bubble : event.bubbles) {
            record_.changes[bubble] = event.time;
        }
        record_.events.push_back({event.kind, frame, event.position});
    }
    foam.events.clear();
    record_.frame = frame;
    std::erase_if(record_.events, [&](const RecordedEvent& event) {
        return event.frame <= frame - kRecordedFrames;
    });
    time_ = foam.time;
}

void History::renumber(int frames) {
    for (RecordedEvent& event : record_.events) {
        event.frame += frames;
    }
}

// shear_since determines the change only up to multiples of the width. The result is right if the
// torus has been sheared by less than half of its width since the previous frame.
void History::shear_recorded_events(const Domain& domain) {
    if (domain.is_plane()) {
        return;
    }
    const double shear = domain.shear_since(domain_);
    for (RecordedEvent& event : record_.events) {
        event.position.x() += shear * event.position.y() / domain.height;
    }
    domain_ = domain;
}

void History::record_pressures(const Foam& foam) {
    record_.first_pressures = pressures_of(snapshot(foam, 1), PressureUnit::Current);
    std::sort(record_.first_pressures.begin(), record_.first_pressures.end());
}

}  // namespace foam::texgen
