// SPDX-License-Identifier: Apache-2.0

#pragma once

// The pixel data of an EXR that stores rows (scan lines) instead of tiles, with the compression ZIP
// or ZIPS. Only exr_encode.cpp uses these declarations.

#include "core/files/file_io.h"
#include "texgen/image/exr_planes.h"

namespace foam::texgen {

/// Options of append_zip_chunks.
struct ExrZip {
    int rows_per_chunk = 16;  // 16 for ZIP, 1 for ZIPS
    int level = 2;            // ExrEncoding::zip_level
    int threads = 1;          // ExrEncoding::threads
};

/// Appends the table of offsets and the chunks of rows to a file that ends with its header. The
/// bytes do not depend on the number of threads.
void append_zip_chunks(const ExrPlanes& planes, const ExrZip& options, Bytes& file);

}  // namespace foam::texgen
