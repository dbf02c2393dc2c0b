#pragma once

#include "texgen/preset/schema.h"

#include <vector>

namespace foam::texgen {

/// The keys of files and their formats.
std::vector<Key> output_keys();

}  // namespace foam::texgen
