// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/profile.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/preset_io.h"

namespace foam::fuzz {

// Parses the input as a profile, and applies the profile to the default preset.
void fuzz_profile(std::string_view input) {
    unless_rejected<texgen::PresetError>([&] {
        texgen::Preset preset;
        const texgen::Profile profile = texgen::parse_profile(input, "mine", "mine.toml");
        texgen::assign(preset, texgen::assignments_for(profile, preset));
        return preset;
    });
}

}  // namespace foam::fuzz
