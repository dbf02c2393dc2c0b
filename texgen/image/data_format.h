// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/pixel_format.h"

namespace foam::texgen {

/// Returns the description of a pixel format that a KTX2 file contains: a data format descriptor
/// with one basic block, as the Khronos Data Format Specification 1.3 describes it.
Bytes data_format_descriptor(PixelFormat format);

}  // namespace foam::texgen
