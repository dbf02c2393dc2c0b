// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/cache/byte_stream.h"

namespace foam::texgen {

// A compact encoding of a frame: about 105 bytes per bubble of a torus before compression. The
// topology is stored as two lists: the half-edges that leave each junction, and one half-edge of
// each bubble. All other links follow from these. The geometry is stored as the values from which
// arcs and areas are computed. README.md lists the values that a state stores; the frame is a part
// of the state.

/// Appends an encoded frame to the bytes of the writer.
void write_frame(const Frame& frame, ByteWriter& writer);

/// Decodes the frame at the present position of the reader. The result equals the frame given to
/// write_frame to the last bit. Throws BadContent if the bytes end too early, if the network is not
/// valid (find_fault in core/network), or if the numbers are not valid (find_frame_fault).
Frame read_frame(ByteReader& reader);

}  // namespace foam::texgen
