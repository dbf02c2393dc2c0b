// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Adds to the description of the sheets of a new flipbook (flipbook_json) the sheets that an
/// earlier flipbook has listed in the same file. If the new flipbook shows other maps, the sheets
/// of the earlier one therefore stay in the file. `file` is the JSON file that the description will
/// replace. A sheet of the earlier flipbook is kept if its image still exists and no new sheet has
/// its map or its file name. If the earlier flipbook differs in anything but its sheets and
/// conventions, for example in its layout, no sheet is kept. Returns the names of the existing
/// images that `file` lists and that are neither kept nor replaced by new sheets. Ignores a file
/// that is missing or that is not the description of a flipbook. Throws InputError if the file
/// exists but cannot be read.
std::vector<std::string> keep_earlier_sheets(Json& description, const std::filesystem::path& file);

}  // namespace foam::texgen
