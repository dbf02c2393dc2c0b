// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/studio/folder.h"

namespace foam::texgen {

/// Returns the answer to /api/program (README.md).
Json describe_program(const StudioFolder& folder);

}  // namespace foam::texgen
