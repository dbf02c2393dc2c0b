// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Checks the header of an EXR file before OpenEXR opens it. The reason: OpenEXR allocates memory
/// for sizes in the header before it knows whether the file is long enough.
///
/// Throws InputError in these cases:
/// - The file is not an EXR of version 2, or has several parts or deep pixels.
/// - An attribute is longer than the rest of the file, or has the wrong size for its type.
/// - There is no channel, or a channel is subsampled.
/// - The image or one of its blocks is too large. A block is a tile, or the rows that are
///   compressed together.
/// - The file is too short for the number of its blocks or pixels.
///
/// Throws OutOfMemory if the machine has too little memory for the image. Also throws the
/// exceptions of OpenEXR (Iex::BaseExc) for other errors in the header.
void check_exr_header(std::span<const std::byte> content);

}  // namespace foam::texgen
