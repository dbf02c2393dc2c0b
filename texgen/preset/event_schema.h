#pragma once

#include "texgen/preset/event.h"
#include "texgen/preset/value.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// One key of an [[event]]: all that reading, checking, writing and documenting it needs.
struct EventKey {
    std::string_view name;
    std::string allowed;  // "an integer from 1 to 1000"
    std::string_view meaning;
    std::span<const EventKind> kinds;                         // that take it
    std::optional<Value> default_value;                       // nothing where an event has none
    std::function<bool(const Value&, Event&)> read;           // false: not allowed, no change
    std::function<std::optional<Value>(const Event&)> write;  // nothing for what needs no saying

    bool is_for(EventKind kind) const;
};

/// Every key there is, `kind` first.
std::span<const EventKey> event_keys();

/// nullptr where there is none of this name.
const EventKey* find_event_key(std::string_view name);

/// The word for a kind: "collapse".
std::string_view name_of(EventKind kind);

/// The names of the keys that a kind takes, with commas.
std::string keys_of(EventKind kind);

}  // namespace foam::texgen
