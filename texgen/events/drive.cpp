// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/drive.h"

#include "texgen/events/chosen_bubbles.h"
#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<DriveOptions> drive_keys() {
    using Options = DriveOptions;
    constexpr Choices<Phases> kPhases = {{{{"same", Phases::Same}, {"random", Phases::Random}}}};
    return {
        key("scale",
            Reals{0.01, 100.0},
            "factor by which the target area, without the oscillation, changes linearly over the "
            "frames of the event",
            &Options::scale),
        key("amplitude",
            Reals{0.0, 0.9},
            "amplitude of the oscillation, as a fraction of the target area",
            &Options::amplitude)
            .in("fraction of the target area"),
        key("period", Reals{1.0, 1e5}, "frames per oscillation", &Options::period).in("frames"),
        key("phase",
            Reals{-1.0, 1.0},
            "phase of the oscillation at its start, in cycles",
            &Options::phase)
            .in("cycles"),
        key("phases",
            kPhases,
            "all bubbles oscillate in phase, or each with a random phase",
            &Options::phases)};
}

void check_drive(const EventCheck& check, const DriveOptions& /*options*/) {
    check_choice(check, true);
}

void advance_drive(const EventBase& event, const DriveOptions& options, EventContext& context) {
    if (context.frame != event.frames.first) {
        return;
    }
    const std::size_t count = event.chosen_count();
    const std::vector<ChosenBubble> chosen = choose_bubbles(event, context, 0, count);
    context.missing += count > 0 ? static_cast<int>(count - chosen.size()) : 0;
    for (const ChosenBubble& one : chosen) {
        const double random_phase =
            options.phases == Phases::Random ? context.random.uniform() : 0.0;
        context.schedules[one.bubble] = {event.frames,
                                         {.from = one.area,
                                          .to = options.scale * one.area,
                                          .amplitude = options.amplitude,
                                          .oscillations = event.frames.length() / options.period,
                                          .phase = options.phase + random_phase},
                                         false};
    }
}

}  // namespace foam::texgen
