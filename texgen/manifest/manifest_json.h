// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns a manifest as JSON, with members in a fixed order and one line per map, file, frame and
/// scene file. FORMAT.md describes the format.
std::string to_json(const Manifest& manifest);

/// Parses the JSON of a manifest. Unknown members are ignored. Throws InputError if the text is not
/// JSON, is not a manifest, or is a manifest of a newer version of the format. `file` is the name
/// of the file, for the message.
Manifest parse_manifest(std::string_view text, const std::string& file);

}  // namespace foam::texgen
