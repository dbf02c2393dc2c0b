// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/event_base.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

#include <cstdint>
#include <limits>

namespace foam::texgen {

namespace {

constexpr int kMaxBubbles = 1'000'000;
constexpr std::int64_t kMaxListedIdentity = std::numeric_limits<BubbleIdentity>::max() - 1;

// A kind of values (value_kinds.h): a single frame, stored as a span of one frame.
struct SingleFrames {
    Integers frame{2, kLastEventFrame};

    std::string allowed() const { return frame.allowed(); }
    std::string schema() const { return frame.schema(); }
    bool read(const Value& value, FrameSpan& member) const {
        const bool allowed = frame.read(value, member.first);
        member.last = allowed ? member.first : member.last;
        return allowed;
    }
    std::optional<Value> write(const FrameSpan& member) const {
        const bool is_single = member.first != 0 && member.first == member.last;
        return is_single ? std::optional(frame.write(member.first)) : std::nullopt;
    }
};

// A kind of values: a span of frames, written as [first, last].
struct FrameSpans {
    Integers frame{2, kLastEventFrame};

    std::string allowed() const {
        return fmt::format("[first, last], each {}, first not above last", frame.allowed());
    }
    std::string schema() const { return list_schema(frame.schema(), 2, 2); }
    bool read(const Value& value, FrameSpan& member) const {
        const auto* list = std::get_if<Value::List>(&value.data);
        FrameSpan span;
        const bool allowed = list != nullptr && list->size() == 2 &&
                             frame.read(list->front(), span.first) &&
                             frame.read(list->back(), span.last) && span.first <= span.last;
        member = allowed ? span : member;
        return allowed;
    }
    std::optional<Value> write(const FrameSpan& member) const {
        if (member.first == member.last) {
            return std::nullopt;
        }
        return Value{Value::List{frame.write(member.first), frame.write(member.last)}};
    }
};

// A kind of values: an instant of foam time, or an interval [from, to].
struct Times {
    Reals time{0.0, 1e12};

    std::string allowed() const {
        return fmt::format("{}, or [from, to] with from not above to", time.allowed());
    }
    std::string schema() const {
        return any_of_schema(time.schema(), list_schema(time.schema(), 2, 2));
    }
    bool read(const Value& value, std::array<double, 2>& member) const {
        std::array<double, 2> span{};
        const auto* list = std::get_if<Value::List>(&value.data);
        const bool is_span = list != nullptr && list->size() == 2;
        const bool allowed = time.read(is_span ? list->front() : value, span[0]) &&
                             time.read(is_span ? list->back() : value, span[1]) &&
                             span[0] <= span[1];
        member = allowed ? span : member;
        return allowed;
    }
    Value write(const std::array<double, 2>& member) const {
        const bool is_instant = member[0] == member[1];
        return is_instant ? time.write(member[0])
                          : Value{Value::List{time.write(member[0]), time.write(member[1])}};
    }
};

// Returns a copy of the key that calls `forget` after it has read an allowed value. In this way,
// frames replace a time that was read before, and a time replaces frames.
Key<EventBase> replacing(Key<EventBase> key, void (*forget)(EventBase& event)) {
    key.read = [read = key.read, forget](const Value& value, EventBase& event) {
        const bool allowed = read(value, event);
        if (allowed) {
            forget(event);
        }
        return allowed;
    };
    return key;
}

// Returns a copy of the key that is restricted to the kinds of events whose member `takes` is true.
Key<EventBase> taken_by(const std::vector<EventTraits>& kinds,
                        bool EventTraits::*takes,
                        const Key<EventBase>& key) {
    std::vector<std::string> names;
    for (const EventTraits& kind : kinds) {
        if (kind.*takes) {
            names.emplace_back(kind.name);
        }
    }
    return key.only_for("kind", std::move(names));
}

}  // namespace

FrameSpan part_of(const FrameSpan& frames, std::size_t index, std::size_t parts) {
    const auto start = [&](std::size_t k) {
        const auto length = static_cast<std::size_t>(frames.length());
        return frames.first + static_cast<int>(k * length / parts);
    };
    return {start(index), start(index + 1) - 1};
}

std::size_t EventBase::chosen_count() const {
    if (!bubbles.empty()) {
        return bubbles.size();
    }
    return sides.empty() ? (at ? 1U : 0U) : static_cast<std::size_t>(count);
}

Keys<EventBase> time_keys() {
    const auto forget_time = [](EventBase& event) { event.time.reset(); };
    const auto forget_frames = [](EventBase& event) { event.frames = {}; };
    return {
        replacing(
            key("frame", SingleFrames{}, "frame at which the event is complete", &EventBase::frames)
                .in("frames"),
            forget_time),
        replacing(key("frames",
                      FrameSpans{},
                      "instead of frame: first and last frame of the event",
                      &EventBase::frames)
                      .in("frames"),
                  forget_time),
        replacing(
            key("time",
                Maybe<Times>{},
                "instead of frames: foam time at which the event is complete, or its start and end",
                &EventBase::time)
                .in("foam time"),
            forget_frames)};
}

Keys<EventBase> choice_keys(const std::vector<EventTraits>& kinds) {
    using Traits = EventTraits;
    return {
        taken_by(kinds,
                 &Traits::takes_bubbles,
                 key("bubble",
                     IntegerLists{{0, kMaxListedIdentity}},
                     "identities of the bubbles; N seeded bubbles have the identities 0 to N - 1",
                     &EventBase::bubbles)),
        taken_by(kinds,
                 &Traits::takes_position,
                 key("at",
                     Maybe<Points>{{{0.0, 1.0}}},
                     "position of the bubble, of the new bubble or of the push, in fractions of "
                     "the image from its lower left corner; if there is no foam at this "
                     "position, no bubble is chosen or created, but a push still moves the "
                     "junctions within its radius",
                     &EventBase::at)
                     .in("fraction of the image width and height")),
        taken_by(kinds,
                 &Traits::takes_bubbles,
                 key("sides",
                     IntegerLists{{2, 100}},
                     "numbers of sides: chooses the smallest bubbles with these numbers of sides, "
                     "one bubble for each number in turn; a collapse of the order in-turn chooses "
                     "each bubble when its turn begins, any other event chooses all bubbles when "
                     "it begins",
                     &EventBase::sides)
                     .in("sides")),
        taken_by(kinds,
                 &Traits::takes_count,
                 key("count",
                     Integers{1, kMaxBubbles},
                     "number of bubbles that the key sides chooses, or number of new bubbles",
                     &EventBase::count)
                     .in("bubbles"))};
}

}  // namespace foam::texgen
