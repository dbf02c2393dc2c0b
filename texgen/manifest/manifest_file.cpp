// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/manifest_file.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/manifest/manifest_json.h"

#include <span>
#include <string>
#include <system_error>

namespace foam::texgen {

std::filesystem::path manifest_path(const std::filesystem::path& path) {
    std::error_code error;  // ignored, since reading the manifest later reports the error
    const bool is_folder = path.empty() || std::filesystem::is_directory(path, error);
    return is_folder ? path / kManifestName : path;
}

Manifest read_manifest(const std::filesystem::path& path) {
    const std::filesystem::path file = manifest_path(path);
    const Bytes bytes = read_file(file, kDescriptionInput);
    return parse_manifest(as_text(bytes), file.string());
}

Manifest manifest_in(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kManifestName;
    return is_existing(file) ? read_manifest(file) : Manifest{};
}

void update_manifest(const std::filesystem::path& folder,
                     const std::function<void(Manifest&)>& change,
                     std::chrono::milliseconds patience) {
    make_folders(folder);
    const std::filesystem::path file = folder / kManifestName;
    const FileLock lock(file.string() + ".lock", patience);
    Manifest manifest = manifest_in(folder);
    change(manifest);
    const std::string text = to_json(manifest);
    write_file(file, std::as_bytes(std::span(text)), Durability::BeforeNaming);
}

}  // namespace foam::texgen
