// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation_files.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"

#include <fmt/core.h>

#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace foam::texgen {

namespace {

// The first line of every file of write_variation. The next run replaces or removes only files that
// begin with exactly this line. If the line changed, the next run would reject the files of earlier
// versions of foamtex.
constexpr std::string_view kMark =
    "# Written by foamtex vary, which replaces this file the next time. Rename it to keep it.\n";
constexpr std::string_view kSuffix = ".toml";

// Returns true if write_variation has written the file. Folders and other files that are not
// regular have no mark.
bool has_mark(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) &&
           as_text(read_file(path, kPresetInput)).starts_with(kMark);
}

}  // namespace

VariationFiles::VariationFiles(std::filesystem::path folder,
                               const std::string& preset,
                               std::size_t count)
    : folder_(std::move(folder)), stem_(preset), digits_(std::to_string(count).size()) {}

std::filesystem::path VariationFiles::sheet() const {
    return folder_ / (stem_ + "_variations.png");
}

std::filesystem::path VariationFiles::preset(std::size_t number) const {
    return folder_ / fmt::format("{}_{:0{}}{}", stem_, number, digits_, kSuffix);
}

std::vector<std::filesystem::path> VariationFiles::earlier() const {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        if (!is_variation_name(entry.path().filename().string())) {
            continue;
        }
        if (!has_mark(entry.path())) {
            throw OutputError(fmt::format(
                "'{}' would be replaced or removed, but was not written by foamtex vary",
                entry.path().string()));
        }
        files.push_back(entry.path());
    }
    return files;
}

bool VariationFiles::is_variation_name(const std::string& name) const {
    const std::string start = stem_ + "_";
    if (!name.starts_with(start) || !name.ends_with(kSuffix) ||
        name.size() <= start.size() + kSuffix.size()) {
        return false;
    }
    const std::string number =
        name.substr(start.size(), name.size() - start.size() - kSuffix.size());
    return number.find_first_not_of("0123456789") == std::string::npos;
}

void write_variation(const std::filesystem::path& path, const std::string& toml) {
    const std::string content = std::string(kMark) + toml;
    write_file(path, std::as_bytes(std::span(content)));
}

}  // namespace foam::texgen
