#include "texgen/preset/event_schema.h"

#include "texgen/preset/value_kinds.h"
#include "texgen/preset/event_frames.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace foam::texgen {

namespace {

constexpr int kMostBubbles = 1'000'000;
constexpr std::int64_t kLargestIdentity = std::numeric_limits<BubbleIdentity>::max() - 1;
constexpr Choices<EventKind, 5> kKinds = {{{{"collapse", EventKind::Collapse},
                                            {"nucleate", EventKind::Nucleate},
                                            {"drive", EventKind::Drive},
                                            {"force", EventKind::Force},
                                            {"shear", EventKind::Shear}}}};
constexpr Choices<NucleationSite> kSites = {
    {{{"junction", NucleationSite::Junction}, {"film", NucleationSite::Film}}}};
constexpr Choices<EventOrder> kOrders = {
    {{{"at-once", EventOrder::AtOnce}, {"in-turn", EventOrder::InTurn}}}};
constexpr Choices<Phases> kPhases = {{{{"same", Phases::Same}, {"random", Phases::Random}}}};

// A single frame, as first and last of a span.
struct SingleFrames {
    Integers frame{2, kLastEventFrame};

    std::string allowed() const { return frame.allowed(); }
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

// [first, last].
struct FrameSpans {
    Integers frame{2, kLastEventFrame};

    std::string allowed() const {
        return fmt::format("[first, last], each {}, in this order", frame.allowed());
    }
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

// An instant, or [from, to].
struct Times {
    Reals time{0.0, 1e12};

    std::string allowed() const {
        return fmt::format("{}, or [from, to] of such, in this order", time.allowed());
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

using EventKinds = std::span<const EventKind>;
constexpr std::array kAll{
    EventKind::Collapse, EventKind::Nucleate, EventKind::Drive, EventKind::Force, EventKind::Shear};
constexpr std::array kCounting{EventKind::Collapse, EventKind::Nucleate, EventKind::Drive};
constexpr std::array kAtPlaces{
    EventKind::Collapse, EventKind::Nucleate, EventKind::Drive, EventKind::Force};
constexpr std::array kOfBubbles{EventKind::Collapse, EventKind::Drive};
constexpr std::array kCollapse{EventKind::Collapse};
constexpr std::array kNucleate{EventKind::Nucleate};
constexpr std::array kDrive{EventKind::Drive};
constexpr std::array kForce{EventKind::Force};
constexpr std::array kShear{EventKind::Shear};

template <class T>
bool is_unsaid(const T& /*value*/) {
    return false;
}
template <class T>
bool is_unsaid(const std::optional<T>& value) {
    return !value.has_value();
}
template <class T>
bool is_unsaid(const std::vector<T>& value) {
    return value.empty();
}

template <class ValueKind>
std::optional<Value> said(const ValueKind& kind, const auto& value) {
    return is_unsaid(value) ? std::nullopt : std::optional(kind.write(value));
}

/// The key whose value is kept in a member; not written where it is what an event has anyway.
template <class ValueKind, class Member>
EventKey key(std::string_view name,
             const ValueKind& kind,
             std::string_view meaning,
             EventKinds kinds,
             Member Event::*member) {
    return {name,
            kind.allowed(),
            meaning,
            kinds,
            said(kind, Event{}.*member),
            [=](const Value& value, Event& event) { return kind.read(value, event.*member); },
            [=](const Event& event) -> std::optional<Value> {
                return event.*member == Event{}.*member
                           ? std::nullopt
                           : std::optional(kind.write(event.*member));
            }};
}

EventKey frame_key(std::string_view name, const auto& kind, std::string_view meaning) {
    return {name,
            kind.allowed(),
            meaning,
            kAll,
            std::nullopt,
            [=](const Value& value, Event& event) {
                const bool allowed = kind.read(value, event.frames);
                event.time = allowed ? std::nullopt : event.time;
                return allowed;
            },
            [=](const Event& event) { return kind.write(event.frames); }};
}

EventKey time_key() {
    EventKey times =
        key("time",
            Maybe<Times>{},
            "instead of frames: the foam time at which it happens, or from and to when",
            kAll,
            &Event::time);
    times.read = [read = times.read](const Value& value, Event& event) {
        const bool allowed = read(value, event);
        event.frames = allowed ? FrameSpan{} : event.frames;
        return allowed;
    };
    return times;
}

std::vector<EventKey> common_keys() {
    return {key("kind", Maybe<decltype(kKinds)>{kKinds}, "what happens", kAll, &Event::kind),
            frame_key("frame", SingleFrames{}, "the frame that shows it done"),
            frame_key("frames",
                      FrameSpans{},
                      "instead of frame: it goes on from the first of these frames to the last"),
            time_key()};
}

std::vector<EventKey> choice_keys() {
    return {key("bubble",
                IntegerLists{{0, kLargestIdentity}},
                "identities of the bubbles; a seeded foam has 0 to bubbles - 1",
                kOfBubbles,
                &Event::bubbles),
            key("at",
                Maybe<Points>{{{0.0, 1.0}}},
                "the bubble, junction or film at this place, in parts of the image from its lower "
                "left; where there is no foam nothing happens",
                kAtPlaces,
                &Event::at),
            key("sides",
                IntegerLists{{2, 100}},
                "the smallest bubbles of so many sides when it begins; of several numbers each in "
                "turn",
                kOfBubbles,
                &Event::sides),
            key("count",
                Integers{1, kMostBubbles},
                "how many bubbles of so many sides, or how many new ones",
                kCounting,
                &Event::count),
            key("order",
                kOrders,
                "whether several bubbles collapse together or one after the other, in equal parts "
                "of the frames",
                kCollapse,
                &Event::order)};
}

std::vector<EventKey> nucleate_keys() {
    return {key("on",
                kSites,
                "where a new bubble begins: three-sided at a junction, two-sided on a film",
                kNucleate,
                &Event::on),
            key("area",
                Reals{0.0002, 100.0},
                "target area of a new bubble, in foam units; above dynamics.t2_area",
                kNucleate,
                &Event::area),
            key("growth",
                Integers{1, kLastEventFrame},
                "frames in which a new bubble grows to its area; several begin evenly over the "
                "event's frames",
                kNucleate,
                &Event::growth)};
}

std::vector<EventKey> drive_keys() {
    return {key("scale",
                Reals{0.01, 100.0},
                "factor of the target area, reached evenly at the last frame",
                kDrive,
                &Event::scale),
            key("amplitude",
                Reals{0.0, 0.9},
                "of a swing of the target area, a part of it",
                kDrive,
                &Event::amplitude),
            key("period", Reals{1.0, 1e5}, "frames of a swing", kDrive, &Event::period),
            key("phase",
                Reals{-1.0, 1.0},
                "of the swing at the start, in turns",
                kDrive,
                &Event::phase),
            key("phases",
                kPhases,
                "whether all bubbles swing together or each from a random phase",
                kDrive,
                &Event::phases)};
}

std::vector<EventKey> force_keys() {
    return {key("radius",
                Reals{0.1, 500.0},
                "of the part that is pushed, in foam units; at most half of a torus' shorter side",
                kForce,
                &Event::radius),
            key("push",
                Points{{-100.0, 100.0}},
                "how far its middle is moved, in foam units, in all; then the foam settles, and "
                "only what has swapped neighbours stays changed",
                kForce,
                &Event::push)};
}

std::vector<EventKey> shear_keys() {
    return {key("strain",
                Reals{-100.0, 100.0},
                "how far the foam is sheared, evenly over the frames: the shift along x over the "
                "height; images of a sheared foam tile in rows that are shifted as far",
                kShear,
                &Event::strain)};
}

std::vector<EventKey> all_keys() {
    std::vector<EventKey> all;
    for (const auto& keys : {common_keys(),
                             choice_keys(),
                             nucleate_keys(),
                             drive_keys(),
                             force_keys(),
                             shear_keys()}) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

}  // namespace

bool EventKey::is_for(EventKind kind) const {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::span<const EventKey> event_keys() {
    static const std::vector<EventKey> keys = all_keys();
    return keys;
}

const EventKey* find_event_key(std::string_view name) {
    const auto keys = event_keys();
    const auto found = std::find_if(
        keys.begin(), keys.end(), [&](const EventKey& key) { return key.name == name; });
    return found != keys.end() ? &*found : nullptr;
}

std::string_view name_of(EventKind kind) {
    const auto* const found =
        std::find_if(kKinds.choices.begin(), kKinds.choices.end(), [&](const auto& choice) {
            return choice.second == kind;
        });
    return found->first;
}

std::string keys_of(EventKind kind) {
    std::string names;
    for (const EventKey& key : event_keys()) {
        if (key.is_for(kind)) {
            names += fmt::format("{}{}", names.empty() ? "" : ", ", key.name);
        }
    }
    return names;
}

}  // namespace foam::texgen
