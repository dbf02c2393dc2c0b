// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/sheet/map_sequence.h"

#include <string_view>

namespace foam::texgen {

/// Reads a frame of a map from its file. If the file has layers, only the channels of the map's
/// layer are kept, and the layer name is removed from the channel names. Throws InputError if the
/// file cannot be read or has no such layer.
Picture read_map_frame(const MapFile& file, std::string_view map);

}  // namespace foam::texgen
