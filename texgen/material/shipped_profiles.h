// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// A profile (profile.h) that is part of the program.
struct ShippedProfile {
    std::string_view name;
    std::string_view toml;  // the whole file, comments included
};

/// Returns all profiles that are part of the program. CMake embeds them from the files of
/// presets/profiles/.
std::span<const ShippedProfile> shipped_profiles();

/// Returns the profile with the given name. Throws PresetError if there is none; the message lists
/// all names and, if a name is similar, suggests it.
const ShippedProfile& find_shipped_profile(std::string_view name);

}  // namespace foam::texgen
