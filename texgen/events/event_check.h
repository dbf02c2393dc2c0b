// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_base.h"

#include <functional>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The properties of a foam that its events depend on.
struct EventSetting {
    bool is_patch = false;
    double t2_area = 0.0;       // foam units
    double shorter_side = 0.0;  // of a torus, foam units
};

/// The arguments of the check of one event of a preset. The check covers conditions between the
/// keys of the event, and conditions between the event and the foam.
struct EventCheck {
    const EventBase& event;
    FrameSpan frames;  // frames of the event, computed if it has a time
    EventSetting setting;
    std::string name;         // "event[2]"
    bool is_touched = false;  // false if only keys outside of the event were assigned
    std::function<bool(std::string_view key)> is_given;  // true if the key was assigned
    std::function<void(std::string_view key, std::string_view reason)> reject;  // throws

    /// Rejects the key for the given reason unless the condition holds.
    void require(bool holds, std::string_view key, std::string_view reason) const {
        if (!holds) {
            reject(key, reason);
        }
    }
    /// Returns `text`. If only keys outside of the event were assigned, the error message begins
    /// with one of these keys. The result is then "event[2].key" + separator + text, so that the
    /// message also names the key of the event.
    std::string about(std::string_view key,
                      std::string_view separator,
                      std::string_view text) const {
        return is_touched
                   ? std::string(text)
                   : name + '.' + std::string(key) + std::string(separator) + std::string(text);
    }
};

}  // namespace foam::texgen
