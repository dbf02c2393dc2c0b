// SPDX-License-Identifier: Apache-2.0

#include "core/files/scratch_folder.h"

#include "core/files/file_io.h"

#include <fmt/core.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <cerrno>
#include <string>
#include <system_error>

namespace foam {

namespace {

std::filesystem::path temporary_folder() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    return error ? std::filesystem::path("/tmp") : folder;
}

}  // namespace

ScratchFolder::ScratchFolder() {
    std::string name = (temporary_folder() / "foamtex-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw OutputError(fmt::format(
            "cannot create the folder '{}': {}", name, std::generic_category().message(errno)));
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace foam
