// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/manifest/manifest_json.h"

#include <string>

namespace foam::fuzz {

void fuzz_manifest(std::string_view input) {
    const auto manifest =
        unless_rejected<InputError>([&] { return texgen::parse_manifest(input, "manifest.json"); });
    if (!manifest) {
        return;
    }
    const std::string written = texgen::to_json(*manifest);
    require(texgen::to_json(texgen::parse_manifest(written, "written.json")) == written,
            "a manifest is read as it was written");
}

}  // namespace foam::fuzz
