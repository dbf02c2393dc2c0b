// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// A file of the page, which is part of the program.
struct PageFile {
    std::string_view name;  // such as "style.css"
    std::string_view content;
};

/// Returns the files of the page. CMake embeds them from page/.
std::span<const PageFile> page_files();

}  // namespace foam::texgen
