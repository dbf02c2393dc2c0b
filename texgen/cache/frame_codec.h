// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/cache/byte_stream.h"

namespace foam::texgen {

// A compact encoding of a frame: about 105 bytes per bubble before compression. Of the topology it
// stores the half-edges that leave each junction and one half-edge of each bubble, from which the
// rest follows. Of the geometry it stores the values from which arcs and areas are computed.
// README.md lists what is stored.

/// Appends a frame.
void write_frame(const Frame& frame, ByteWriter& writer);

/// Returns the frame that write_frame wrote, equal to the last bit. Throws BadContent if the bytes
/// are no frame.
Frame read_frame(ByteReader& reader);

}  // namespace foam::texgen
