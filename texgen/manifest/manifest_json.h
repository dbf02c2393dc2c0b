#pragma once

#include "texgen/manifest/manifest.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// A manifest as JSON (README.md has the format): members in a fixed order, one file a line.
std::string to_json(const Manifest& manifest);

/// Undoes to_json; members it does not know are passed over. Throws InputError, in the name of
/// `file`, where the text is no JSON, no manifest, or one of a newer version.
Manifest parse_manifest(std::string_view text, const std::string& file);

}  // namespace foam::texgen
