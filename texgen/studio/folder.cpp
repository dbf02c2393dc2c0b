// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/folder.h"

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/manifest/manifest_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr int kBakeDepth = 3;
constexpr std::size_t kMaxBakes = 200;  // largest number of manifests that `bakes` finds

}  // namespace

StudioFolder::StudioFolder(const std::filesystem::path& folder) {
    make_folders(folder);
    std::error_code error;
    path_ = std::filesystem::canonical(folder.empty() ? "." : folder, error);
    if (error || !std::filesystem::is_directory(path_, error)) {
        throw OutputError(fmt::format("'{}' is not a folder", folder.string()));
    }
}

std::filesystem::path StudioFolder::below(const std::string& relative) const {
    const std::filesystem::path given(relative);
    const bool leaves = given.is_absolute() || std::ranges::find(given, "..") != given.end();
    const auto reject = [&](const char* reason) {
        throw PathRejected(fmt::format("'{}': {}", shown_text(relative), reason));
    };
    if (leaves) {
        reject("must be a path below the folder of the studio");
    }
    if (!is_harmless(relative)) {
        reject("must not contain control characters");
    }
    std::error_code error;
    std::filesystem::path resolved = std::filesystem::weakly_canonical(path_ / given, error);
    if (error) {
        reject("cannot be resolved");
    }
    const auto [end, rest] = std::ranges::mismatch(path_, resolved);
    if (end != path_.end()) {
        reject("must not leave the folder of the studio through a link");
    }
    return resolved;
}

std::vector<std::string> StudioFolder::preset_files() const {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(path_, error)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file(error) && name.ends_with(".toml") && is_plain_name(name)) {
            names.push_back(name);
        }
    }
    std::ranges::sort(names);
    return names;
}

std::vector<std::filesystem::path> StudioFolder::bakes() const {
    std::vector<std::filesystem::path> found;
    std::error_code error;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    // The iterator does not follow links, so it stays below the folder.
    std::filesystem::recursive_directory_iterator entry(path_, options, error);
    for (; !error && entry != end(entry) && found.size() < kMaxBakes; entry.increment(error)) {
        if (entry->path().filename() == kManifestName) {
            found.push_back(entry->path().lexically_relative(path_));
        }
        if (entry.depth() >= kBakeDepth) {
            entry.disable_recursion_pending();
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace foam::texgen
