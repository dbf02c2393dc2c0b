// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"
#include "texgen/vector/format.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns the format of the files of a preset if they are vector files (output.pattern), otherwise
/// nullptr.
const VectorFormat* vector_format_of(const Preset& preset);

/// Returns the options of a preset on which vector files depend. Keeps references to the preset.
VectorSettings vector_settings(const Preset& preset);

/// Returns the names of the parts of a frame (VectorFormat::parts), each of which is one vector
/// file. The name of a part takes the place of {map} in the name of its file. Precondition: the
/// files of the preset are vector files.
std::vector<std::string> vector_parts(const Preset& preset);

/// Returns the words that take the place of {map} in the names of the files of a frame. These are
/// the names of vector_parts if the files are vector files, and otherwise the file_word of each
/// image.
std::vector<std::string> file_words(const Preset& preset);

/// Checks a preset whose files are vector files; does nothing for other presets. Throws
/// std::invalid_argument if the preset has packings or sheets, if frames show two foams (a
/// cross-fade), or as VectorFormat::check does. The message is one line and names the key.
void check_vector_files(const Preset& preset);

/// Returns the content of a vector file of a frame. `part` is one of the names that
/// VectorFormat::parts returns. Throws std::invalid_argument if the frame is a part of a
/// cross-fade, and as VectorFormat::encode does.
std::string encode_vector(const VectorFormat& format,
                          const SimulatedFrame& shown,
                          const Preset& preset,
                          std::string_view part);

/// Returns a frame as SVG, with the options of the table `vector`. Throws as encode_vector does.
std::string to_svg(const SimulatedFrame& shown, const Preset& preset);

}  // namespace foam::texgen
