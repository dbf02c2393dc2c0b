// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_section.h"

#include "core/geometry/elementary.h"

namespace foam::texgen {

ReliefSection::ReliefSection(ReliefProfile profile, double angle) {
    switch (profile) {
        case ReliefProfile::Dome:
            section_ = DomeSection{1.0 / ieee::tan(angle)};
            break;
        case ReliefProfile::Ridge:
            section_ = RidgeSection{};
            break;
        case ReliefProfile::Wet:
            section_ = WetSection{};
            break;
    }
}

double ReliefSection::height(double smooth) const {
    return visit([=](const auto& section) { return section.height(smooth); });
}

double ReliefSection::slope(double smooth) const {
    return visit([=](const auto& section) { return section.slope(smooth); });
}

double ReliefSection::distance(double smooth) const {
    return visit([=](const auto& section) { return section.distance(smooth); });
}

double ReliefSection::smooth(double distance) const {
    return visit([=](const auto& section) { return section.smooth(distance); });
}

}  // namespace foam::texgen
