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

/// Checks what the keys of one event of a preset require of each other and of the foam.
struct EventCheck {
    const EventBase& event;
    FrameSpan frames;  // of the event
    EventSetting setting;
    std::string name;         // "event[2]"
    bool is_touched = false;  // false if only keys outside of the event were assigned
    std::function<bool(std::string_view key)> is_given;  // true if the key was assigned
    std::function<void(std::string_view key, std::string_view reason)> reject;  // throws

    void require(bool holds, std::string_view key, std::string_view reason) const {
        if (!holds) {
            reject(key, reason);
        }
    }
    /// Returns `text`, or, for a message about a key outside of the event, "event[2].key text".
    std::string about(std::string_view key,
                      std::string_view separator,
                      std::string_view text) const {
        return is_touched
                   ? std::string(text)
                   : name + '.' + std::string(key) + std::string(separator) + std::string(text);
    }
};

}  // namespace foam::texgen
