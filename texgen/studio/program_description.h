// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/studio/folder.h"

namespace foam::texgen {

/// Returns the answer to the request GET /api/program (texgen/studio/REQUESTS.md). It contains what
/// a page must know about the program, such as its presets and maps, and lists the preset files in
/// `folder`.
Json describe_program(const StudioFolder& folder);

}  // namespace foam::texgen
