// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/shear.h"

#include "texgen/keys/value_kinds.h"

#include <algorithm>

namespace foam::texgen {

Keys<ShearOptions> shear_keys() {
    return {key("strain",
                Reals{-100.0, 100.0},
                "shear strain: how far the upper border moves to the right, divided by the height; "
                "applied evenly over the frames. Images of a sheared foam fit together without "
                "seams if each row of images is displaced to the right by this distance, relative "
                "to the row below it",
                &ShearOptions::strain)};
}

void check_shear(const EventCheck& check, const ShearOptions& /*options*/) {
    check.require_fit(!check.setting.is_patch,
                      "kind",
                      " = ",
                      "\"shear\" is only allowed with foam.domain = \"torus\"");
}

double strain_at(int frame, const EventBase& event, const ShearOptions& options) {
    const int length = event.frames.length();
    return options.strain * std::clamp(frame - event.frames.first + 1, 0, length) / length;
}

void advance_shear(const EventBase& event, const ShearOptions& options, EventContext& context) {
    const double part = 1.0 / event.frames.length();
    context.change.strain += part * options.strain;
}

}  // namespace foam::texgen
