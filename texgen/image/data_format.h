// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/pixel_format.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Returns the data format descriptor with which a KTX2 file describes its pixel format. The
/// descriptor has a single block, which is a "basic descriptor block" (Khronos Data Format
/// Specification 1.3).
Bytes data_format_descriptor(PixelFormat format);

/// Throws InputError if a data format descriptor is too short, or if it says that the colors of a
/// KTX2 file are multiplied by alpha.
void check_straight_alpha(std::span<const std::byte> descriptor);

}  // namespace foam::texgen
