// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/history.h"

#include "core/foam/frame.h"
#include "core/geometry/elementary.h"
#include "texgen/maps/bubble_pressure.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

// Calls change(average, value) for the pressure, the area and the number of sides of a bubble.
template <class Change>
void for_each_value(BubbleValues& averages, const BubbleValues& values, const Change& change) {
    change(averages.pressure, values.pressure);
    change(averages.area, values.area);
    change(averages.sides, values.sides);
}

}  // namespace

History::History(const Foam& foam, double smoothing) : smoothing_(smoothing), time_(foam.time) {}

void History::record_events(Foam& foam, int frame, double strain) {
    shear_recorded_events(strain - strain_);
    strain_ = strain;
    record_.births.resize(foam.next_identity, time_);
    record_.changes.resize(foam.next_identity, time_);
    newborn_.clear();
    for (const TopologyEvent& event : foam.events) {
        for (const BubbleIdentity bubble : event.bubbles) {
            record_.changes[bubble] = event.time;
        }
        if (event.kind == TopologyEventKind::Birth) {
            record_.births[event.bubbles.front()] = event.time;
            newborn_.push_back(event.bubbles.front());
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

void History::shear_recorded_events(double strain) {
    for (RecordedEvent& event : record_.events) {
        event.position.x() += strain * event.position.y();
    }
}

void History::record_pressures(const Foam& foam) {
    record_.first_pressures =
        pressures_of(present_values(snapshot(foam, 1)), PressureUnit::Current);
    std::sort(record_.first_pressures.begin(), record_.first_pressures.end());
}

void History::set_pressures(std::vector<double> first_pressures) {
    record_.first_pressures = std::move(first_pressures);
}

// The averages of a bubble begin with its values in the first frame after its birth. A bubble is
// new if its identity did not exist at the last call. A boiling bubble that is born again has its
// old identity; it is new if it is in newborn_.
void History::average_values(const Foam& foam) {
    if (smoothing_ == 0.0) {
        return;
    }
    const double weight = 1.0 / (1.0 + smoothing_);
    const auto approach = [weight](double& average, double value) {
        average += weight * (value - average);
    };
    const Frame frame = snapshot(foam, 1);
    const FoamValues present = values_to_average(frame);
    std::vector<BubbleValues>& averages = record_.averages.bubbles;
    const std::size_t known_count = averages.size();
    averages.resize(foam.next_identity);
    const PerBubble<BubbleIdentity> identities = identities_of(frame);
    for (std::size_t k = 0; k < identities.size(); ++k) {
        BubbleValues& average = averages[identities[k]];
        const bool is_reborn = std::ranges::find(newborn_, identities[k]) != newborn_.end();
        if (identities[k] >= known_count || is_reborn) {
            average = present.bubbles[k];
        }
        for_each_value(average, present.bubbles[k], approach);
    }
    if (known_count == 0) {
        record_.averages.mean_area = present.mean_area;
    }
    approach(record_.averages.mean_area, present.mean_area);
}

// A cycle of n frames changes an average from v to c + k v. Here k = (1 - weight)^n, with the
// weight of average_values, and c depends only on the values in the cycle. After infinitely many
// cycles, v = c / (1 - k); this value replaces the average. The averages of a bubble that was born
// in the cycle depend only on the values since its birth. They are not changed.
void History::close_averages(const FoamRecord& start, int frames) {
    if (smoothing_ == 0.0) {
        return;
    }
    const double kept_fraction = ieee::pow(smoothing_ / (1.0 + smoothing_), frames);
    const auto close = [kept_fraction](double& average, double before) {
        average = (average - kept_fraction * before) / (1.0 - kept_fraction);
    };
    std::vector<BubbleValues>& averages = record_.averages.bubbles;
    for (std::size_t k = 0; k < averages.size(); ++k) {
        if (record_.births[k] == start.births[k]) {
            for_each_value(averages[k], start.averages.bubbles[k], close);
        }
    }
    close(record_.averages.mean_area, start.averages.mean_area);
}

}  // namespace foam::texgen
