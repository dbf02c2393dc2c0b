// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the text of a preset file that extends the preset `base`, which is a name or a path. The
/// file sets the keys of the assignments, in the order of preset_keys. If there are several
/// assignments to a key, the last one counts. Assignments to keys of events are left out.
std::string extending_preset(std::string_view base, std::span<const Assignment> assignments);

}  // namespace foam::texgen
