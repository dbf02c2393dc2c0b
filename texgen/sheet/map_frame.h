#pragma once

#include "texgen/image/picture.h"
#include "texgen/sheet/map_sequence.h"

#include <string_view>

namespace foam::texgen {

/// Reads a frame of a map from its file. Of a file with layers, keeps the channels of the map's
/// layer and removes the layer from their names. Throws InputError, also for a missing layer.
Picture read_map_frame(const MapFile& file, std::string_view map);

}  // namespace foam::texgen
