// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The names of image files that an earlier flipbook has listed. All of these files exist.
struct EarlierSheets {
    std::vector<std::string> unlisted;  // neither kept in the list nor replaced by new sheets
    std::vector<std::string> replaced;  // made from another bake, and replaced by new sheets
};

/// Adds to the description of the sheets of a new flipbook (flipbook_json) the sheets that an
/// earlier flipbook has listed in the same JSON file. If the new flipbook shows other maps, the
/// sheets of the earlier one therefore stay in the file. `earlier` is the content of the file that
/// the description will replace, and `folder` is its folder. A sheet of the earlier flipbook is
/// kept if its image exists in this folder and no new sheet has its map or its file name. If the
/// earlier flipbook differs in anything but its sheets and conventions, for example in its layout,
/// no sheet is kept. Ignores a content that is not the description of a flipbook, and names that
/// are not plain (is_plain_name), because the file may come from an untrusted source.
EarlierSheets keep_earlier_sheets(Json& description,
                                  std::string_view earlier,
                                  const std::filesystem::path& folder);

}  // namespace foam::texgen
