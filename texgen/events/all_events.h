// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/collapse.h"
#include "texgen/events/drive.h"
#include "texgen/events/event_base.h"
#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"
#include "texgen/events/force.h"
#include "texgen/events/nucleate.h"
#include "texgen/events/shear.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// One [[event]] of a preset. It has the shared properties and the options of every kind; only the
/// options of its own kind are used.
struct Event : EventBase {
    CollapseOptions collapse;
    NucleateOptions nucleate;
    DriveOptions drive;
    ForceOptions force;
    ShearOptions shear;
};

/// A kind of event: its traits, its keys, and two functions. `check` checks the options of an
/// event. `advance` applies the event before the step to each of its frames.
struct EventKind : EventTraits {
    Keys<Event> (*keys)() = nullptr;
    void (*check)(const EventCheck& check, const Event& event) = nullptr;
    void (*advance)(const Event& event, EventStage& stage) = nullptr;
};

/// Makes a kind of event whose options are a member of Event.
template <auto member, auto keys, auto check, auto advance>
constexpr EventKind kind_of(const EventTraits& traits) {
    return {traits,
            [] { return keys_in("", member, keys()); },
            [](const EventCheck& checked, const Event& event) { check(checked, event.*member); },
            [](const Event& event, EventStage& stage) { advance(event, event.*member, stage); }};
}

/// Every kind of event, in the order of all listings.
inline constexpr std::array kEventKinds = {
    kind_of<&Event::collapse, collapse_keys, check_collapse, advance_collapse>(kCollapseEvent),
    kind_of<&Event::nucleate, nucleate_keys, check_nucleate, advance_nucleate>(kNucleateEvent),
    kind_of<&Event::drive, drive_keys, check_drive, advance_drive>(kDriveEvent),
    kind_of<&Event::force, force_keys, check_force, advance_force>(kForceEvent),
    kind_of<&Event::shear, shear_keys, check_shear, advance_shear>(kShearEvent)};

/// Returns the kind with the given name. Precondition: it exists.
const EventKind& find_event_kind(std::string_view name);

/// Returns the keys of an [[event]], `kind` first. The condition of a key lists the kinds that
/// accept it; all kinds accept a key without a condition.
std::span<const Key<Event>> event_keys();

/// Returns the names of the kinds that accept a key, separated by commas.
std::string kinds_of(const KeyInfo& key);

/// Returns the names of the keys that a kind accepts, separated by commas.
std::string keys_of(std::string_view kind);

/// Returns the table of all kinds in Markdown, as in README.md.
std::string describe_event_kinds_in_markdown();

}  // namespace foam::texgen
