// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/honeycomb.h"
#include "texgen/events/all_events.h"
#include "texgen/preset/assignment.h"

#include <string>
#include <string_view>

namespace foam::texgen::test {

/// A torus of 4 x 4 hexagons of area 1, with the identities 0 to 15, and the changes that events
/// make to it.
struct EventSubject {
    Foam foam = honeycomb(4, 4);
    Random random{7};
    StateChange change{};
    DrivenSchedules schedules{};

    EventContext context(int frame) {
        return {.frame = frame,
                .foam = foam,
                .random = random,
                .t2_area = 0.01,
                .view = {},
                .image_size = {100.0, 100.0},
                .change = change,
                .schedules = schedules};
    }
};

/// Returns the message with which a check rejects an event: "key: reason"; "foam: reason" if it
/// calls EventCheck::reject_foam; or "accepted". Only the key `given` counts as assigned.
template <class Options>
std::string checked(const EventBase& event,
                    const Options& options,
                    void (*check)(const EventCheck&, const Options&),
                    const EventSetting& setting = {.is_patch = false,
                                                   .t2_area = 0.01,
                                                   .shorter_side = 4.0},
                    std::string_view given = {}) {
    const EventCheck all{
        .event = event,
        .frames = event.frames,
        .setting = setting,
        .name = "event[1]",
        .is_given = [=](std::string_view key) { return key == given; },
        .reject =
            [](std::string_view key, std::string_view reason) {
                throw PresetError(std::string(key) + ": " + std::string(reason));
            },
        .reject_foam =
            [](std::string_view reason) { throw PresetError("foam: " + std::string(reason)); }};
    try {
        check(all, options);
    } catch (const PresetError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace foam::texgen::test
