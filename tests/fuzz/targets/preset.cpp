// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/preset_io.h"

#include <string>

namespace foam::fuzz {

void fuzz_preset(std::string_view input) {
    const auto preset = unless_rejected<texgen::PresetError>(
        [&] { return texgen::parse_preset(input, "foam", "foam.toml"); });
    if (!preset) {
        return;
    }
    const std::string written = texgen::to_toml(*preset);
    const texgen::Preset again = texgen::parse_preset(written, "foam", "written.toml");
    require(texgen::to_toml(again) == written, "a preset is read as it was written");
}

}  // namespace foam::fuzz
