#pragma once

#include "texgen/image/exr.h"
#include "texgen/sheet/map_sequence.h"

#include <string_view>

namespace foam::texgen {

/// A frame of a map from its EXR, alone: channels of a layer lose its name. Throws InputError, also
/// where the file has no such layer.
ExrImage read_exr_frame(const MapFile& file, std::string_view map);

}  // namespace foam::texgen
