// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_start.h"

#include "core/files/file_io.h"
#include "core/io/format_error.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/preset.h"

#include <string>

namespace foam::fuzz {

namespace {

// Reads a text as the start of the loop of a preset. Its hash is the hash of the preset.
void match(const texgen::Preset& preset, const std::string& text) {
    unless_rejected<InputError, FormatError>([&] {
        require(texgen::matching_loop_start(preset, text, "loop.json").has_value(),
                "a start with the hash of a preset belongs to the preset");
        return true;
    });
}

}  // namespace

void fuzz_loop_start(std::string_view input) {
    const auto start = unless_rejected<InputError, FormatError>(
        [&] { return texgen::read_loop_start(input, "loop.json"); });
    if (!start) {
        return;
    }
    const std::string written = texgen::write_loop_start(*start, "hash");
    require(texgen::write_loop_start(texgen::read_loop_start(written, "written.json"), "hash") ==
                written,
            "the start of a loop is read as it was written");
    texgen::Preset preset;
    require(!texgen::matching_loop_start(preset, written, "loop.json"),
            "a start with another hash does not belong to a preset");
    using texgen::FoamKind;
    for (const FoamKind kind : {FoamKind::Torus, FoamKind::Patch}) {
        preset.shape.kind = kind;
        match(preset, texgen::write_loop_start(*start, texgen::loop_hash(preset)));
    }
}

}  // namespace foam::fuzz
