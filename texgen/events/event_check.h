// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_base.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The properties of a foam that its events depend on.
struct EventSetting {
    bool is_patch = false;
    double t2_area = 0.0;       // square foam units
    double shorter_side = 0.0;  // shorter side of a torus, foam units
    // The identities that an event names must be below this number: foam.bubbles plus the number
    // of bubbles that events create.
    std::int64_t identity_limit = std::numeric_limits<std::int64_t>::max();
};

/// The argument of EventKind::check, which checks one event of a preset. The check covers
/// conditions that involve several keys of the event, or a key of the event and a property of the
/// foam. The check runs after the keys of one file or one command line have been assigned. In this
/// struct, "assigned" means assigned by this file or command line.
struct EventCheck {
    const EventBase& event;
    FrameSpan frames;  // frames of the event; computed from EventBase::time if that is set
    EventSetting setting;
    std::string name;  // name of the event in messages, such as "event[2]"
    std::function<bool(std::string_view key)> is_given;  // true if the key was assigned
    // Throws PresetError. The message quotes an assignment, followed by the reason. The assignment
    // is the first of these that exists:
    // - the last assignment to the key
    // - the last assignment to any key of the event
    // - the last assignment to a key outside of the event, such as foam.bubbles, on which the
    //   allowed values of events depend
    // - the last assignment of all
    std::function<void(std::string_view key, std::string_view reason)> reject;
    // Throws PresetError. The message quotes an assignment, followed by the reason. The assignment
    // is the first of these that exists:
    // - the last assignment to a key outside of the event on which the allowed values of events
    //   depend
    // - the last assignment to any key of the event
    // - the last assignment of all
    std::function<void(std::string_view reason)> reject_foam;

    /// Calls `reject` with the key and the reason unless `holds` is true. `holds` must be a
    /// condition on keys of the event alone; for a condition that depends on the foam, too, call
    /// require_fit.
    void require(bool holds, std::string_view key, std::string_view reason) const {
        if (!holds) {
            reject(key, reason);
        }
    }
    /// Rejects a value of a key that does not fit the foam, unless `holds` is true. If the key was
    /// assigned, calls `reject` with the reason. Otherwise the value was assigned earlier, or it is
    /// the default. This function then calls `reject_foam` with the reason "event[2].key" +
    /// separator + reason, so that the message names the key of the event, too. `separator` is, for
    /// example, " = ".
    void require_fit(bool holds,
                     std::string_view key,
                     std::string_view separator,
                     std::string_view reason) const {
        if (holds) {
            return;
        }
        if (is_given(key)) {
            reject(key, reason);
        }
        reject_foam(name + '.' + std::string(key) + std::string(separator) + std::string(reason));
    }
};

}  // namespace foam::texgen
