#include "texgen/animation/timeline.h"

#include "core/foam/locate.h"
#include "texgen/animation/camera.h"
#include "texgen/animation/new_bubble.h"
#include "texgen/preset/event_frames.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace foam::texgen {

namespace {

// A new bubble starts with so many T2 areas, so that it does not vanish at once.
constexpr double kFirstAreas = 2.0;

// Different for each event, a renewal having that after the last, and another stream than the
// seeding's.
std::uint64_t seed_of(const Preset& preset, std::size_t event) {
    return (preset.seeding.seed ^ 0x9e3779b97f4a7c15U) + 0xd1b54a32d192ed03U * (event + 1);
}

ChosenBubble chosen(const Foam& foam, BubbleId bubble) {
    return {foam.identities[bubble], foam.target_areas[bubble]};
}

std::vector<ChosenBubble> all_bubbles(const Foam& foam) {
    std::vector<ChosenBubble> all;
    for (const BubbleId bubble : foam.network.bubbles()) {
        all.push_back(chosen(foam, bubble));
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        all.push_back({bubble.identity, bubble.target_area});
    }
    return all;
}

std::optional<ChosenBubble> choose_identity(const Foam& foam, BubbleIdentity identity) {
    if (const auto bubble = find_bubble(foam, identity)) {
        return chosen(foam, *bubble);
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        if (bubble.identity == identity) {
            return ChosenBubble{identity, bubble.target_area};
        }
    }
    return std::nullopt;
}

// The part of the frames, of `parts` in all, that comes at place `index`.
FrameSpan part_of(const FrameSpan& frames, std::size_t index, std::size_t parts) {
    const auto start = [&](std::size_t k) {
        const auto length = static_cast<std::size_t>(frames.length());
        return frames.first + static_cast<int>(k * length / parts);
    };
    return {start(index), start(index + 1) - 1};
}

// The smallest bubbles of so many sides; of several numbers each in turn, from `turn` on, and those
// that are left out where one is used up.
std::vector<ChosenBubble> choose_by_sides(const std::vector<int>& numbers,
                                          const Foam& foam,
                                          std::size_t turn,
                                          std::size_t count) {
    std::vector<std::vector<BubbleId>> found;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        found.push_back(bubbles_of_sides(foam, numbers[(turn + k) % numbers.size()]));
    }
    std::vector<ChosenBubble> all;
    for (std::size_t rank = 0; rank < foam.network.bubble_count(); ++rank) {
        for (const std::vector<BubbleId>& of_number : found) {
            if (rank < of_number.size() && all.size() < count) {
                all.push_back(chosen(foam, of_number[rank]));
            }
        }
    }
    return all;
}

// Bubbles by their identities: `count` of them, from place `turn` on.
std::vector<ChosenBubble> choose_by_identity(const std::vector<BubbleIdentity>& bubbles,
                                             const Foam& foam,
                                             std::size_t turn,
                                             std::size_t count) {
    std::vector<ChosenBubble> all;
    for (std::size_t k = turn; k < turn + count; ++k) {
        if (const auto one = choose_identity(foam, bubbles[k])) {
            all.push_back(*one);
        }
    }
    return all;
}

}  // namespace

Timeline::Timeline(const Preset& preset) : thresholds_(preset.thresholds), image_(preset.image) {
    if (preset.loop.kind == LoopKind::Flow) {
        renewal_ = {.bubbles = 0,
                    .growth = preset.loop.growth,
                    .random = Random(seed_of(preset, preset.events.size()))};
    }
    for (std::size_t k = 0; k < preset.events.size(); ++k) {
        Event event = preset.events[k];
        event.frames = *frames_of(event, preset.frames);  // a checked preset has them
        entries_.push_back({std::move(event), Random(seed_of(preset, k))});
    }
}

StateChange Timeline::changes_to(int frame, Foam& foam) {
    std::erase_if(driven_, [&](const auto& entry) { return entry.second.frames.last < frame; });
    StateChange change;
    for (Entry& entry : entries_) {
        const Event& event = entry.event;
        if (frame >= event.frames.first && frame <= event.frames.last) {
            begin(entry, frame, foam);
            add_motion(event, frame, foam, change);
        }
    }
    if (renewal_) {
        renew(frame, foam);
    }
    for (const auto& [bubble, driven] : driven_) {
        const double passed = static_cast<double>(frame - driven.frames.first + 1) /
                              static_cast<double>(driven.frames.length());
        const bool is_last = frame == driven.frames.last;
        change.driven.push_back(
            {bubble, target_at(driven.course, passed), driven.vanishes && is_last});
    }
    return change;
}

Vec2 Timeline::place_of(const Event& event, const Foam& foam) const {
    const Domain& domain = foam.domain;
    return domain.is_plane() ? point_in_view(view_, image_, *event.at)
                            : Vec2((*event.at)[0] * domain.width, (*event.at)[1] * domain.height);
}

// The bubbles of an event: `count` of them, from place `turn` on; all where it names none.
std::vector<ChosenBubble> Timeline::choose(const Event& event,
                                           const Foam& foam,
                                           std::size_t turn,
                                           std::size_t count) const {
    if (count == 0) {
        return all_bubbles(foam);
    }
    if (!event.sides.empty()) {
        return choose_by_sides(event.sides, foam, turn, count);
    }
    if (!event.at) {
        return choose_by_identity(event.bubbles, foam, turn, count);
    }
    const auto found = identity_at(foam, place_of(event, foam));
    return found ? std::vector{*choose_identity(foam, *found)} : std::vector<ChosenBubble>{};
}

// What a shear and a force do on the way to a frame.
void Timeline::add_motion(const Event& event,
                          int frame,
                          const Foam& foam,
                          StateChange& change) const {
    const double part = 1.0 / event.frames.length();
    if (event.kind == EventKind::Shear) {
        change.strain += part * event.strain;
    } else if (event.kind == EventKind::Force) {
        const Vec2 by = part * Vec2(event.push[0], event.push[1]);
        const Vec2 center = place_of(event, foam) + (frame - event.frames.first) * by;
        change.pushes.push_back({center, event.radius, by});
    }
}

void Timeline::begin(Entry& entry, int frame, Foam& foam) {
    switch (*entry.event.kind) {
        case EventKind::Collapse:
            begin_collapse(entry.event, frame, foam);
            break;
        case EventKind::Nucleate:
            nucleate(entry, frame, foam);
            break;
        case EventKind::Drive:
            begin_drive(entry, frame, foam);
            break;
        case EventKind::Force:
        case EventKind::Shear:
            break;  // is the same in every frame
    }
}

void Timeline::begin_collapse(const Event& event, int frame, const Foam& foam) {
    const std::size_t count = event.bubbles_named();
    const std::size_t parts = event.order == EventOrder::InTurn ? count : 1;
    for (std::size_t part = 0; part < parts; ++part) {
        const FrameSpan frames = part_of(event.frames, part, parts);
        if (frames.first != frame) {
            continue;
        }
        for (const ChosenBubble& one : choose(event, foam, part, count / parts)) {
            const TargetCourse course{.from = one.area, .to = thresholds_.t2_area};
            driven_[one.bubble] = {frames, course, true};
        }
    }
}

void Timeline::begin_drive(Entry& entry, int frame, const Foam& foam) {
    const Event& event = entry.event;
    if (frame != event.frames.first) {
        return;
    }
    for (const ChosenBubble& one : choose(event, foam, 0, event.bubbles_named())) {
        const double more = event.phases == Phases::Random ? entry.random.uniform() : 0.0;
        driven_[one.bubble] = {event.frames,
                               {.from = one.area,
                                .to = event.scale * one.area,
                                .amplitude = event.amplitude,
                                .swings = event.frames.length() / event.period,
                                .phase = event.phase + more},
                               false};
    }
}

void Timeline::nucleate(Entry& entry, int frame, Foam& foam) {
    const Event& event = entry.event;
    const double first = first_area(event.area);
    const auto count = static_cast<std::size_t>(event.count);
    for (std::size_t k = 0; k < count; ++k) {
        if (part_of(event.frames, k, count).first != frame) {
            continue;
        }
        const std::optional<BubbleId> bubble =
            event.at ? nucleate_near(event.on, place_of(event, foam), first, foam)
                     : nucleate_anywhere(event.on, first, entry.random, foam);
        if (bubble) {
            grow(foam, *bubble, {frame, frame + event.growth - 1}, event.area);
        }
    }
}

// The foam that it is first asked for has as many bubbles as there are to be.
void Timeline::renew(int frame, Foam& foam) {
    if (renewal_->bubbles == 0) {
        renewal_->bubbles = foam.network.bubble_count();
    }
    const double area = foam.domain.area() / static_cast<double>(renewal_->bubbles);
    const double first = first_area(area);
    for (std::size_t k = foam.network.bubble_count(); k < renewal_->bubbles; ++k) {
        const auto bubble =
            nucleate_anywhere(NucleationSite::Junction, first, renewal_->random, foam);
        if (bubble) {
            grow(foam, *bubble, {frame, frame + renewal_->growth - 1}, area);
        }
    }
}

double Timeline::first_area(double area) const {
    return std::min(area, kFirstAreas * thresholds_.t2_area);
}

// Of a new bubble, to its area over these frames.
void Timeline::grow(const Foam& foam, BubbleId bubble, const FrameSpan& frames, double area) {
    driven_[foam.identities[bubble]] = {
        frames, {.from = foam.target_areas[bubble], .to = area}, false};
}

}  // namespace foam::texgen
