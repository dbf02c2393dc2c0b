// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/event_io.h"

#include "texgen/keys/nearest.h"
#include "texgen/preset/event_frames.h"
#include "texgen/preset/rejection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::string_view kTable = "event";

// The parts of a path such as event[2].kind: the number of the event, counted from 1, and the name
// of the key. The name is empty for the table event[2] itself.
struct EventPath {
    std::size_t number = 0;  // 0 if the path is malformed
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

// Returns the name of the key of events that is most similar to an unknown name, or an empty view
// if no name is similar.
std::string_view nearest_name(std::string_view name) {
    std::vector<std::string_view> names;
    for (const KeyInfo& key : event_keys()) {
        names.push_back(key.path);
    }
    return nearest(name, names);
}

// Returns the last assignment to the key `name` of the event with the given number, or to any key
// of this event if `name` is empty. Returns nullptr if there is no such assignment.
const Assignment* last_assignment(std::span<const Assignment> assignments,
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

// The allowed values of events also depend on these keys of other tables.
constexpr std::array<std::string_view, 7> kKeysThatLimitEvents{"foam.domain",
                                                               "foam.bubbles",
                                                               "image.size",
                                                               "dynamics.t2_area",
                                                               "frames.time_step",
                                                               "frames.step_growth",
                                                               "frames.warm_up"};

// Returns the last assignment to a key in kKeysThatLimitEvents, or nullptr if there is none.
const Assignment* last_of_keys_that_limit_events(std::span<const Assignment> assignments) {
    const auto last = std::find_if(assignments.rbegin(), assignments.rend(), [](const auto& one) {
        return std::find(kKeysThatLimitEvents.begin(), kKeysThatLimitEvents.end(), one.key) !=
               kKeysThatLimitEvents.end();
    });
    return last != assignments.rend() ? &*last : nullptr;
}

// Rejects the first candidate that is not null. If all are null, rejects the last of all
// assignments.
[[noreturn]] void reject_first(std::initializer_list<const Assignment*> candidates,
                               std::span<const Assignment> assignments,
                               std::string_view reason) {
    for (const Assignment* const candidate : candidates) {
        if (candidate != nullptr) {
            reject(*candidate, reason);
        }
    }
    reject(assignments.back(), reason);
}

void check_keys_of_kind(const EventCheck& check, const Event& event) {
    for (const Key<Event>& key : event_keys()) {
        const bool is_set = check.is_given(key.path) || !key.is_default(event);
        check.require(
            !is_set || !key.condition || key.condition->allows(event.kind),
            key.path,
            fmt::format(
                "not a key of kind \"{}\"; must be one of {}", event.kind, keys_of(event.kind)));
    }
}

void check_frames(const EventCheck& check) {
    constexpr std::string_view kRule =
        "exactly one of the keys frame, frames and time must be given";
    const int given_count = (check.is_given("frame") ? 1 : 0) + (check.is_given("frames") ? 1 : 0) +
                            (check.is_given("time") ? 1 : 0);
    check.require(given_count <= 1, check.is_given("frames") ? "frames" : "time", kRule);
    check.require(check.event.frames.first != 0 || check.event.time, "kind", kRule);
}

// Returns the properties of the foam on which events depend. The area of a torus is foam.bubbles,
// and its aspect ratio is the aspect ratio of the image.
EventSetting setting_of(const Preset& preset) {
    const auto [shorter, longer] = std::minmax(preset.image.width, preset.image.height);
    std::int64_t identities = preset.seeding.bubbles;
    for (const Event& event : preset.events) {
        const bool creates = !event.kind.empty() && find_event_kind(event.kind).creates_bubbles;
        identities += creates ? event.count : 0;
    }
    return {
        .is_patch = preset.shape.kind == FoamKind::Patch,
        .t2_area = preset.thresholds.t2_area,
        .shorter_side = std::sqrt(preset.seeding.bubbles * (static_cast<double>(shorter) / longer)),
        .identity_limit = identities};
}

EventCheck check_of(const Preset& preset,
                    std::size_t number,
                    std::span<const Assignment> assignments) {
    return {.event = preset.events[number - 1],
            .frames = {},
            .setting = setting_of(preset),
            .name = fmt::format("event[{}]", number),
            .is_given =
                [=](std::string_view key) {
                    return last_assignment(assignments, number, key) != nullptr;
                },
            .reject =
                [=](std::string_view key, std::string_view reason) {
                    reject_first({last_assignment(assignments, number, key),
                                  last_assignment(assignments, number),
                                  last_of_keys_that_limit_events(assignments)},
                                 assignments,
                                 reason);
                },
            .reject_foam =
                [=](std::string_view reason) {
                    reject_first({last_of_keys_that_limit_events(assignments),
                                  last_assignment(assignments, number)},
                                 assignments,
                                 reason);
                }};
}

void check_event(EventCheck check, const Event& event, const Preset& preset) {
    check.require(
        !event.kind.empty(),
        {},
        fmt::format("the event must have a kind, {}", find_key(event_keys(), "kind")->allowed));
    check_keys_of_kind(check, event);
    check_frames(check);
    const std::optional<FrameSpan> frames = frames_of(event, preset.frames);
    check.require_fit(
        frames.has_value(),
        "time",
        " ",
        fmt::format(
            "must be a time of frame {} or earlier; frames.time_step, frames.step_growth and "
            "frames.warm_up determine the times of frames",
            kLastEventFrame));
    check.frames = *frames;
    find_event_kind(event.kind).check(check, event);
}

}  // namespace

bool is_event_key(std::string_view key) {
    return key == kTable || key.starts_with("event[") || key.starts_with("event.");
}

void assign_event(Preset& preset, const Assignment& assignment) {
    const EventPath path = parse_path(assignment.key);
    const bool is_table = std::holds_alternative<Value::Table>(assignment.value.data);
    if (path.number == 0) {
        reject(assignment,
               "an event must be a table in an array of tables, which begins with [[event]]");
    }
    if (path.name.empty() && is_table && path.number == preset.events.size() + 1) {
        preset.events.emplace_back();
        return;
    }
    if (path.number > preset.events.size()) {
        reject(assignment,
               fmt::format("the preset has no event {}; the number of its events is {}",
                           path.number,
                           preset.events.size()));
    }
    const Key<Event>* key = find_key(event_keys(), path.name);
    if (key == nullptr) {
        reject_unknown(assignment, nearest_name(path.name));
    }
    if (!key->read(assignment.value, preset.events[path.number - 1])) {
        reject_value(assignment, *key);
    }
}

void check_events(const Preset& preset, std::span<const Assignment> assignments) {
    for (std::size_t k = 0; k < preset.events.size(); ++k) {
        check_event(check_of(preset, k + 1, assignments), preset.events[k], preset);
    }
}

std::string events_to_toml(const Preset& preset) {
    std::string toml;
    for (const Event& event : preset.events) {
        toml += "\n[[event]]\n";
        for (const Key<Event>& key : event_keys()) {
            if (!key.is_default(event)) {
                toml += fmt::format("{} = {}\n", key.path, to_toml(*key.write(event)));
            }
        }
    }
    return toml;
}

std::string describe_event_keys() {
    std::string text = "[[event]]\n";
    for (const KeyInfo& key : event_keys()) {
        text += describe(key) + fmt::format("    for kinds: {}\n", kinds_of(key));
    }
    return text;
}

}  // namespace foam::texgen
