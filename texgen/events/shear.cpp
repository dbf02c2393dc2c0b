// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/shear.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<ShearOptions> shear_keys() {
    return {key("strain",
                Reals{-100.0, 100.0},
                "shear strain, shift along x / height, applied evenly over the frames; images of a "
                "sheared foam tile in rows with the same shift",
                &ShearOptions::strain)};
}

void check_shear(const EventCheck& check, const ShearOptions& /*options*/) {
    check.require(!check.setting.is_patch,
                  "kind",
                  check.qualified_reason(
                      "kind", " = ", "\"shear\" is only allowed with foam.domain = \"torus\""));
}

void advance_shear(const EventBase& event, const ShearOptions& options, EventContext& context) {
    const double part = 1.0 / event.frames.length();
    context.change.strain += part * options.strain;
}

}  // namespace foam::texgen
