#pragma once

#include "core/foam/frame.h"
#include "texgen/cache/byte_stream.h"

namespace foam::texgen {

// A frame in about 105 bytes a bubble, before compression: of its topology only which half-edges
// leave every junction, and one half-edge of every bubble, from which all else follows; of its
// geometry what arcs and areas are computed from (README.md says what is kept).

void write_frame(const Frame& frame, ByteWriter& writer);

/// The same frame, to the last bit. Throws BadContent where it is none.
Frame read_frame(ByteReader& reader);

}  // namespace foam::texgen
