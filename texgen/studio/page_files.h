// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// A file of the studio's page. The program contains the files of the page.
struct PageFile {
    std::string_view name;  // such as "style.css"
    std::string_view content;
};

/// Returns the files of the studio's page. CMake embeds them from the folder texgen/studio/page.
std::span<const PageFile> page_files();

}  // namespace foam::texgen
