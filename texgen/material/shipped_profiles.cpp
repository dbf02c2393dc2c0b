// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/shipped_profiles.h"

#include "texgen/keys/nearest.h"
#include "texgen/preset/assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace foam::texgen {

const ShippedProfile& find_shipped_profile(std::string_view name) {
    const auto profiles = shipped_profiles();
    const auto found = std::ranges::find(profiles, name, &ShippedProfile::name);
    if (found != profiles.end()) {
        return *found;
    }
    std::vector<std::string_view> names;
    for (const ShippedProfile& profile : profiles) {
        names.push_back(profile.name);
    }
    throw PresetError(fmt::format("profile '{}': must be a .toml file or one of {}{}",
                                  name,
                                  fmt::join(names, ", "),
                                  did_you_mean(name, names)));
}

}  // namespace foam::texgen
