// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the key belongs to an event, such as event[2].kind. Also returns true for
/// malformed keys of events, such as "event" or event.kind.
bool is_event_key(std::string_view key);

/// Stores the value of a key of an event in the preset. An assignment can also stand for the n-th
/// table [[event]] itself: its key is then event[n], and its value is a Value::Table. Such an
/// assignment adds the n-th event; the preset must have n - 1 events. Throws PresetError if the key
/// is malformed or unknown, if the event does not exist, or if the value is not allowed.
void assign_event(Preset& preset, const Assignment& assignment);

/// Checks that each event of a preset has a kind, and exactly one of the keys frame, frames and
/// time. Also checks that each event has only keys of its kind, and is possible with the foam.
/// Throws PresetError otherwise; the message names an assignment that may be the cause.
void check_events(const Preset& preset, std::span<const Assignment> assignments);

/// Returns the events of a preset as TOML. Keys that have their defaults are left out.
std::string events_to_toml(const Preset& preset);

/// Returns a description of all keys of events for users: default, meaning, allowed values, and the
/// kinds of events that accept the key.
std::string describe_event_keys();

}  // namespace foam::texgen
