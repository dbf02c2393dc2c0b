// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/profile.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/preset_io.h"

namespace foam::fuzz {

// Parses the input as a profile, and applies the profile to the default preset. Then applies the
// profile again: the first time may have changed which map has the colors of the preset.
void fuzz_profile(std::string_view input) {
    unless_rejected<texgen::PresetError>([&] {
        texgen::Preset preset;
        const texgen::Profile profile = texgen::parse_profile(input, "mine", "mine.toml");
        for (int time = 0; time < 2; ++time) {
            texgen::assign(preset, texgen::assignments_for(profile, preset));
        }
        return preset;
    });
}

}  // namespace foam::fuzz
