// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/sheet/map_sequence.h"

#include <string_view>

namespace foam::texgen {

/// Reads a frame of a map from its file. If the file contains several maps as layers, only the
/// channels in the layer of the map are kept. The name of the layer is then removed from the names
/// of these channels. Throws InputError if the file cannot be read or has no such layer.
Picture read_map_frame(const MapFile& file, std::string_view map);

}  // namespace foam::texgen
