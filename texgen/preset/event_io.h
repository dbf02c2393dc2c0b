#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if a key belongs to an event or was meant to: event[2].kind, event.
bool is_event_key(std::string_view key);

/// Stores the value of an event's key in the preset; the table event[n] itself adds the n-th event.
/// Throws PresetError for an unknown key or a value that is not allowed.
void assign_event(Preset& preset, const Assignment& assignment);

/// Checks that each event has a kind, frames and only keys of its kind, and that it fits the foam.
/// Throws PresetError, which names the last assignment that matters.
void check_events(const Preset& preset, std::span<const Assignment> assignments);

/// Writes the events as TOML, without values that are defaults.
std::string events_to_toml(const Preset& preset);

/// Returns the reference of all keys of events: default, meaning, allowed values, kinds.
std::string describe_event_keys();

}  // namespace foam::texgen
