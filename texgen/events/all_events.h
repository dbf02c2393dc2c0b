// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/collapse.h"
#include "texgen/events/drive.h"
#include "texgen/events/event_base.h"
#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"
#include "texgen/events/force.h"
#include "texgen/events/nucleate.h"
#include "texgen/events/shear.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// One [[event]] of a preset: the shared properties, and the options of every kind of event. Only
/// the options of the event's own kind are used.
struct Event : EventBase {
    CollapseOptions collapse;
    NucleateOptions nucleate;
    DriveOptions drive;
    ForceOptions force;
    ShearOptions shear;
};

/// A kind of event: its traits, its keys, and two functions. `check` rejects an event with invalid
/// options. `advance` adds the effect of an event to the time step that leads to one frame. The
/// timeline calls `advance` once for each frame of the event, before the step to this frame.
struct EventKind : EventTraits {
    Keys<Event> (*keys)() = nullptr;
    void (*check)(const EventCheck& check, const Event& event) = nullptr;
    void (*advance)(const Event& event, EventContext& context) = nullptr;
};

/// Returns the kind of event whose options are the given member of Event.
template <auto member, auto keys, auto check, auto advance>
constexpr EventKind kind_of(const EventTraits& traits) {
    return {
        traits,
        [] { return nested_keys("", member, keys()); },
        [](const EventCheck& checked, const Event& event) { check(checked, event.*member); },
        [](const Event& event, EventContext& context) { advance(event, event.*member, context); }};
}

/// All kinds of events, in the order in which documentation and messages list them.
inline constexpr std::array kEventKinds = {
    kind_of<&Event::collapse, collapse_keys, check_collapse, advance_collapse>(kCollapseEvent),
    kind_of<&Event::nucleate, nucleate_keys, check_nucleate, advance_nucleate>(kNucleateEvent),
    kind_of<&Event::drive, drive_keys, check_drive, advance_drive>(kDriveEvent),
    kind_of<&Event::force, force_keys, check_force, advance_force>(kForceEvent),
    kind_of<&Event::shear, shear_keys, check_shear, advance_shear>(kShearEvent)};

/// Returns the kind with the given name. Precondition: the kind exists.
const EventKind& find_event_kind(std::string_view name);

/// Returns the keys of an [[event]], with `kind` first. The condition of a key lists the kinds that
/// accept it. A key without a condition is accepted by all kinds.
std::span<const Key<Event>> event_keys();

/// Returns the names of the kinds that accept a key, separated by commas.
std::string kinds_of(const KeyInfo& key);

/// Returns the names of the keys that a kind accepts, separated by commas.
std::string keys_of(std::string_view kind);

/// Returns the table of all kinds in Markdown. texgen/events/README.md contains this table.
std::string describe_event_kinds_in_markdown();

}  // namespace foam::texgen
