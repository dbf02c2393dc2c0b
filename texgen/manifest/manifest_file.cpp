// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/manifest_file.h"

#include "texgen/image/file_io.h"
#include "texgen/manifest/file_lock.h"
#include "texgen/manifest/manifest_json.h"

#include <fmt/core.h>

#include <span>
#include <string>
#include <system_error>

namespace foam::texgen {

namespace {

std::filesystem::path file_of(const std::filesystem::path& path) {
    std::error_code error;  // reading the file reports what is wrong
    return std::filesystem::is_directory(path, error) ? path / kManifestName : path;
}

bool matches(const BakedSet& set, std::string_view preset) {
    return preset.empty() || set.preset == preset;
}

std::string line_of(const BakedSet& set) {
    return fmt::format("{} (seed {}, {} x {})", set.preset, set.seed, set.width, set.height);
}

// Returns the error message for the case that `count` sets match the preset. `sets` is the list of
// all sets as text, with commas. Precondition: `count` is not 1.
std::string choice_error(const std::string& file,
                         std::string_view preset,
                         int count,
                         const std::string& sets) {
    if (sets.empty()) {
        return fmt::format("'{}' lists no images", file);
    }
    if (count == 0) {
        return fmt::format(
            "'{}' has no images of preset '{}'; must be one of: {}", file, preset, sets);
    }
    return fmt::format("'{}' has several sets of images: {}; {}",
                       file,
                       sets,
                       preset.empty() ? "choose one with --preset NAME"
                                      : "bake each set into its own folder with --out");
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& path) {
    const std::filesystem::path file = file_of(path);
    const Bytes bytes = read_file(file, kDescriptionInput);
    return parse_manifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                          file.string());
}

const BakedSet& choose_set(const Manifest& manifest,
                           std::string_view preset,
                           const std::filesystem::path& path) {
    const BakedSet* chosen = nullptr;
    std::string sets;
    int count = 0;
    for (const BakedSet& set : manifest.sets) {
        sets += fmt::format("{}{}", sets.empty() ? "" : ", ", line_of(set));
        chosen = matches(set, preset) ? &set : chosen;
        count += matches(set, preset) ? 1 : 0;
    }
    if (count != 1) {
        throw InputError(choice_error(file_of(path).string(), preset, count, sets));
    }
    return *chosen;
}

Manifest manifest_in(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kManifestName;
    return is_existing(file) ? read_manifest(file) : Manifest{};
}

void update_manifest(const std::filesystem::path& folder,
                     const std::function<void(Manifest&)>& change) {
    make_folders(folder);
    const std::filesystem::path file = folder / kManifestName;
    const FileLock lock(file.string() + ".lock");
    Manifest manifest = manifest_in(folder);
    change(manifest);
    const std::string text = to_json(manifest);
    write_file(file, std::as_bytes(std::span(text)), Durability::BeforeNaming);
}

}  // namespace foam::texgen
