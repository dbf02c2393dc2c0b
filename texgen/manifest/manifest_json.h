// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns a manifest as JSON (README.md describes the format), with members in a fixed order and
/// one line per map, file and frame.
std::string to_json(const Manifest& manifest);

/// Parses the JSON of a manifest. Unknown members are ignored. Throws InputError, whose message
/// names `file`, if the text is not JSON, is not a manifest, or is a manifest of a newer version.
Manifest parse_manifest(std::string_view text, const std::string& file);

}  // namespace foam::texgen
