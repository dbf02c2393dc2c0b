#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Whether a key is one of an event, or a slip that was meant as one: event[2].kind, event.
bool is_event_key(std::string_view key);

/// Puts the value of an event's key into the preset; the table event[n] itself adds the n-th event.
/// Throws PresetError for a value or key that is not allowed.
void assign_event(Preset& preset, const Assignment& assignment);

/// What ties the keys of an event together: each has a kind, frames and the keys of its kind.
/// Blames the assignments that were made last. Throws PresetError.
void check_events(const Preset& preset, std::span<const Assignment> assignments);

/// The events in TOML; what an event has anyway is left out.
std::string events_to_toml(const Preset& preset);

/// The reference of all keys of an event: allowed values, meaning, kinds.
std::string describe_event_keys();

}  // namespace foam::texgen
