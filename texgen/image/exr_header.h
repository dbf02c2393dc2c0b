// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Checks the header of an EXR file before OpenEXR opens it, because OpenEXR allocates memory for
/// sizes in the header before it knows whether the file is long enough.
///
/// Throws InputError if the file is not an EXR of version 2, if it has several parts or deep
/// pixels, if an attribute is longer than the rest of the file or has the wrong size for its type,
/// if there is no channel or a subsampled channel, if the image or one of its blocks is too large,
/// or if the file is too short for the number of its blocks or pixels. (A block is a tile, or the
/// rows that are compressed together.) Throws OutOfMemory if the machine has too little memory for
/// the image. Also throws the exceptions of OpenEXR (Iex::BaseExc) for other errors in the header.
void check_exr_header(std::span<const std::byte> content);

}  // namespace foam::texgen
