// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Checks the header of an EXR file before OpenEXR opens it, because OpenEXR allocates memory for
/// sizes in the header before it knows whether the file is long enough. Throws InputError if an
/// attribute is longer than the file or has another size than its type, if the file has several
/// parts or deep pixels, if it has no channel or a subsampled channel, if an image or one of its
/// blocks is too large, or if the file is too short for the number of its blocks or pixels.
void check_exr_header(std::span<const std::byte> content);

}  // namespace foam::texgen
