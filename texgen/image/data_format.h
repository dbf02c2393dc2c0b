// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/pixel_format.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Returns the description of a pixel format that a KTX2 file contains: a data format descriptor
/// with one basic block, as the Khronos Data Format Specification 1.3 describes it.
Bytes data_format_descriptor(PixelFormat format);

/// Throws InputError if a data format descriptor is too short, or if it says that the colors of a
/// KTX2 file are multiplied by alpha.
void check_straight_alpha(std::span<const std::byte> descriptor);

}  // namespace foam::texgen
