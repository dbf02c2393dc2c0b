#include "texgen/preset/event_io.h"

#include "texgen/preset/event_frames.h"
#include "texgen/preset/event_schema.h"
#include "texgen/preset/nearest.h"
#include "texgen/preset/refusal.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::string_view kTable = "event";

// event[2].kind: the number of the event, from 1, and the name of the key, which is empty for the
// table itself.
struct EventPath {
    std::size_t number = 0;  // 0 where the path is malformed
    std::string_view name;
};

EventPath parse_path(std::string_view path) {
    const std::size_t end = path.find(']');
    if (!path.starts_with("event[") || end == std::string_view::npos) {
        return {};
    }
    EventPath parsed;
    const char* const last = path.data() + end;
    const auto [stop, error] =
        std::from_chars(path.data() + kTable.size() + 1, last, parsed.number);
    path.remove_prefix(end + 1);
    if (error != std::errc() || stop != last || (!path.empty() && path.front() != '.')) {
        return {};
    }
    parsed.name = path.empty() ? path : path.substr(1);
    return parsed;
}

std::string_view nearest_name(std::string_view name) {
    std::vector<std::string_view> names;
    for (const EventKey& key : event_keys()) {
        names.push_back(key.name);
    }
    return nearest(name, names);
}

// The assignment of this batch that was made last to an event; to the key alone, if it is given.
const Assignment* last_of(std::span<const Assignment> assignments,
                          std::size_t number,
                          std::string_view name = {}) {
    for (auto last = assignments.rbegin(); last != assignments.rend(); ++last) {
        const EventPath path = parse_path(last->key);
        if (path.number == number && (name.empty() || path.name == name)) {
            return &*last;
        }
    }
    return nullptr;
}

// The keys of other tables on which it depends what an event may say.
constexpr std::array<std::string_view, 7> kOtherSides{"foam.domain",
                                                      "foam.bubbles",
                                                      "image.size",
                                                      "dynamics.t2_area",
                                                      "frames.time_step",
                                                      "frames.step_growth",
                                                      "frames.warm_up"};

const Assignment& last_of_other_sides(std::span<const Assignment> assignments) {
    const auto last = std::find_if(assignments.rbegin(), assignments.rend(), [](const auto& one) {
        return std::find(kOtherSides.begin(), kOtherSides.end(), one.key) != kOtherSides.end();
    });
    return last != assignments.rend() ? *last : assignments.back();
}

// Blames the key where it was given in this batch, else whatever else was of the event, else what
// changed the other side of a limit.
[[noreturn]] void refuse_event(std::span<const Assignment> assignments,
                               std::size_t number,
                               std::string_view name,
                               std::string_view reason) {
    const Assignment* blamed = last_of(assignments, number, name);
    blamed = blamed != nullptr ? blamed : last_of(assignments, number);
    refuse(blamed != nullptr ? *blamed : last_of_other_sides(assignments), reason);
}

// One event whose keys are looked at together.
struct Checked {
    const Event& event;
    std::size_t number;
    std::span<const Assignment> assignments;

    void require(bool holds, std::string_view name, std::string_view reason) const {
        if (!holds) {
            refuse_event(assignments, number, name, reason);
        }
    }
    bool is_touched() const { return last_of(assignments, number) != nullptr; }
    bool is_given(std::string_view name) const {
        return last_of(assignments, number, name) != nullptr;
    }
};

void check_keys_of_kind(const Checked& checked) {
    const EventKind kind = *checked.event.kind;
    for (const EventKey& key : event_keys()) {
        const bool said = checked.is_given(key.name) || key.write(checked.event).has_value();
        checked.require(
            !said || key.is_for(kind),
            key.name,
            fmt::format("no key of kind \"{}\", which takes {}", name_of(kind), keys_of(kind)));
    }
}

void check_frames(const Checked& checked) {
    const int ways = (checked.is_given("frame") ? 1 : 0) + (checked.is_given("frames") ? 1 : 0) +
                     (checked.is_given("time") ? 1 : 0);
    checked.require(ways <= 1,
                    checked.is_given("frames") ? "frames" : "time",
                    "one of frame, frames and time says when");
    checked.require(checked.event.frames.first != 0 || checked.event.time,
                    "kind",
                    "the event must have a frame, frames or a time");
}

void check_choice(const Checked& checked, const FrameSpan& span) {
    const Event& event = checked.event;
    const int ways =
        (event.bubbles.empty() ? 0 : 1) + (event.at ? 1 : 0) + (event.sides.empty() ? 0 : 1);
    checked.require(ways <= 1,
                    event.sides.empty() ? "at" : "sides",
                    "bubbles are chosen by one of bubble, at, sides");
    checked.require(event.kind == EventKind::Drive || ways == 1,
                    "kind",
                    "the event must choose bubbles by bubble, at or sides");
    checked.require(!checked.is_given("count") || !event.sides.empty(),
                    "count",
                    "counts bubbles that are chosen by sides");
    const auto frames = static_cast<std::size_t>(span.length());
    checked.require(
        event.order == EventOrder::AtOnce || event.bubbles_named() <= frames,
        "order",
        fmt::format(
            "{} bubbles in turn need as many frames, there are {}", event.bubbles_named(), frames));
}

void check_new_bubbles(const Checked& checked, const Preset& preset) {
    const double t2_area = preset.thresholds.t2_area;
    checked.require(
        checked.event.area > t2_area,
        "area",
        checked.is_touched()
            ? fmt::format("must be above dynamics.t2_area = {}", t2_area)
            : fmt::format("must be below event[{}].area = {}", checked.number, checked.event.area));
    checked.require(!checked.event.at || checked.event.count == 1,
                    "count",
                    "must be 1 where the event has a place");
}

void check_force(const Checked& checked, const Preset& preset) {
    checked.require(checked.event.at.has_value(), "kind", "the event must have a place, at");
    if (preset.shape.kind == FoamKind::Patch) {
        return;
    }
    const auto [shorter, longer] = std::minmax(preset.image.width, preset.image.height);
    const double largest =
        0.5 * std::sqrt(preset.seeding.bubbles * (static_cast<double>(shorter) / longer));
    checked.require(
        checked.event.radius <= largest,
        "radius",
        fmt::format("{}must be at most half of the torus' shorter side, {:.3g}",
                    checked.is_touched() ? "" : fmt::format("event[{}].radius ", checked.number),
                    largest));
}

void check_shear(const Checked& checked, const Preset& preset) {
    checked.require(
        preset.shape.kind == FoamKind::Torus,
        "kind",
        fmt::format("{}\"shear\" is only for foam.domain = \"torus\"",
                    checked.is_touched() ? "" : fmt::format("event[{}].kind = ", checked.number)));
}

void check_event(const Checked& checked, const Preset& preset) {
    checked.require(checked.event.kind.has_value(),
                    {},
                    fmt::format("the event must have a kind, {}", find_event_key("kind")->allowed));
    check_keys_of_kind(checked);
    check_frames(checked);
    const std::optional<FrameSpan> span = frames_of(checked.event, preset.frames);
    checked.require(
        span.has_value(),
        "time",
        fmt::format("must come before frame {}, as frames.time_step has it", kLastEventFrame));
    switch (*checked.event.kind) {
        case EventKind::Collapse:
        case EventKind::Drive:
            check_choice(checked, *span);
            break;
        case EventKind::Nucleate:
            check_new_bubbles(checked, preset);
            break;
        case EventKind::Force:
            check_force(checked, preset);
            break;
        case EventKind::Shear:
            check_shear(checked, preset);
            break;
    }
}

std::string kinds_of(const EventKey& key) {
    std::string kinds;
    for (const EventKind kind : key.kinds) {
        kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", name_of(kind));
    }
    return kinds;
}

}  // namespace

bool is_event_key(std::string_view key) {
    return key == kTable || key.starts_with("event[") || key.starts_with("event.");
}

void assign_event(Preset& preset, const Assignment& assignment) {
    const EventPath path = parse_path(assignment.key);
    const bool is_table = std::holds_alternative<Value::Table>(assignment.value.data);
    if (path.number == 0) {
        refuse(assignment, "events are tables of a list: each begins with [[event]]");
    }
    if (path.name.empty() && is_table && path.number == preset.events.size() + 1) {
        preset.events.emplace_back();
        return;
    }
    if (path.number > preset.events.size()) {
        refuse(assignment, fmt::format("there are {} events", preset.events.size()));
    }
    const EventKey* key = find_event_key(path.name);
    if (key == nullptr) {
        refuse_unknown(assignment, nearest_name(path.name));
    }
    if (!key->read(assignment.value, preset.events[path.number - 1])) {
        refuse(assignment, "must be " + key->allowed);
    }
}

void check_events(const Preset& preset, std::span<const Assignment> assignments) {
    for (std::size_t k = 0; k < preset.events.size(); ++k) {
        check_event({preset.events[k], k + 1, assignments}, preset);
    }
}

std::string events_to_toml(const Preset& preset) {
    std::string toml;
    for (const Event& event : preset.events) {
        toml += "\n[[event]]\n";
        for (const EventKey& key : event_keys()) {
            if (const std::optional<Value> value = key.write(event)) {
                toml += fmt::format("{} = {}\n", key.name, to_toml(*value));
            }
        }
    }
    return toml;
}

std::string describe_event_keys() {
    std::string text = "\n[[event]]\n";
    for (const EventKey& key : event_keys()) {
        const std::optional<Value>& value = key.default_value;
        text += value ? fmt::format("{} = {}\n", key.name, to_toml(*value))
                      : fmt::format("{}\n", key.name);
        text += fmt::format("    {}\n    {}\n    of {}\n", key.meaning, key.allowed, kinds_of(key));
    }
    return text;
}

}  // namespace foam::texgen
