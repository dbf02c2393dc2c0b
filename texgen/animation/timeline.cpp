// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/timeline.h"

#include "texgen/preset/event_frames.h"

#include <algorithm>
#include <utility>

namespace foam::texgen {

namespace {

// Returns the seed for the random numbers of the event with the given index, counted from 0. The
// seeds of the events differ from each other and from the seed of the foam. In a loop of the kind
// "flow", the creation of new bubbles (`renew`) uses the number of events as its index.
std::uint64_t seed_of(const Preset& preset, std::size_t event) {
    return (preset.seeding.seed ^ 0x9e3779b97f4a7c15U) + 0xd1b54a32d192ed03U * (event + 1);
}

// Returns the target area of a driven bubble at a frame, and whether the bubble must vanish at the
// end of the step to this frame.
DrivenBubble driven_at(int frame, BubbleIdentity bubble, const DrivenSchedule& driven) {
    const double passed = static_cast<double>(frame - driven.frames.first + 1) /
                          static_cast<double>(driven.frames.length());
    const bool is_last = frame == driven.frames.last;
    return {bubble, target_at(driven.schedule, passed), driven.vanishes && is_last};
}

}  // namespace

double strain_of_events(const Preset& preset, int state) {
    double strain = 0.0;
    for (Event event : preset.events) {
        if (event.kind == kShearEvent.name) {
            event.frames = *frames_of(event, preset.frames);
            strain += strain_at(state, event, event.shear);
        }
    }
    return strain;
}

Timeline::Timeline(const Preset& preset)
    : t2_area_(preset.thresholds.t2_area), image_size_(preset.image.width, preset.image.height) {
    if (preset.loop.kind == LoopKind::Flow) {
        renewal_ = {.bubbles = 0,
                    .growth = preset.loop.growth,
                    .random = Random(seed_of(preset, preset.events.size()))};
    }
    for (std::size_t k = 0; k < preset.events.size(); ++k) {
        Event event = preset.events[k];
        // frames_of returns a value, because the preset has passed check_events.
        event.frames = *frames_of(event, preset.frames);
        entries_.push_back({std::move(event), Random(seed_of(preset, k)), 0});
    }
}

StateChange Timeline::changes_to(int frame, Foam& foam) {
    std::erase_if(schedules_, [&](const auto& entry) { return entry.second.frames.last < frame; });
    StateChange change;
    for (auto& [event, random, missing] : entries_) {
        if (frame >= event.frames.first && frame <= event.frames.last) {
            EventContext context{
                frame, foam, random, t2_area_, view_, image_size_, change, schedules_};
            find_event_kind(event.kind).advance(event, context);
            missing += context.missing;
        }
    }
    if (renewal_) {
        renew(frame, foam);
    }
    for (const auto& [bubble, driven] : schedules_) {
        change.driven.push_back(driven_at(frame, bubble, driven));
    }
    return change;
}

std::vector<int> Timeline::missing_bubbles() const {
    std::vector<int> missing;
    for (const Entry& entry : entries_) {
        missing.push_back(entry.missing);
    }
    return missing;
}

// Creates new bubbles until the foam has as many bubbles as at the first call of `renew`. Schedules
// their growth to the mean area that the foam has with this number of bubbles. Creates fewer
// bubbles if nucleate_anywhere fails.
void Timeline::renew(int frame, Foam& foam) {
    if (renewal_->bubbles == 0) {
        renewal_->bubbles = foam.network.bubble_count();
    }
    const double area = foam.domain.area() / static_cast<double>(renewal_->bubbles);
    const double first = first_area(area, t2_area_);
    for (std::size_t k = foam.network.bubble_count(); k < renewal_->bubbles; ++k) {
        const auto bubble =
            nucleate_anywhere(NucleationSite::Junction, first, renewal_->random, foam);
        if (bubble) {
            const FrameSpan frames{frame, frame + renewal_->growth - 1};
            grow_bubble(foam, *bubble, frames, area, schedules_);
        }
    }
}

}  // namespace foam::texgen
