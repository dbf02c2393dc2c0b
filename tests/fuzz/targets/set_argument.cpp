// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <span>
#include <string>

namespace foam::fuzz {

namespace {

texgen::Preset preset_with(std::string_view argument) {
    texgen::Preset preset;
    const texgen::Assignment assignment = texgen::read_set_argument(std::string(argument));
    texgen::assign(preset, std::span(&assignment, 1));
    return preset;
}

}  // namespace

void fuzz_set_argument(std::string_view input) {
    const auto preset = unless_rejected<texgen::PresetError>([&] { return preset_with(input); });
    if (preset) {
        // An argument may have text that is not UTF-8, which a preset rejects.
        unless_rejected<texgen::PresetError>(
            [&] { return texgen::parse_preset(texgen::to_toml(*preset), "foam", "written.toml"); });
    }
}

}  // namespace foam::fuzz
