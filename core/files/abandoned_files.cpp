// SPDX-License-Identifier: Apache-2.0

#include "core/files/abandoned_files.h"

#include <chrono>
#include <regex>
#include <string>
#include <system_error>

namespace foam {

namespace {

// A temporary file is abandoned if its last change is longer ago than this. Writing a file takes
// less time, and the clocks of machines that share a folder differ by less.
constexpr std::chrono::hours kMinAge{24};

// Returns true for names such as NAME.foamtex-123-4.part (unique_sibling in file_io.cpp).
bool is_temporary(const std::string& name) {
    static const std::regex pattern(R"(.+\.foamtex-\d+-\d+\.part)");
    return name.ends_with(".part") && std::regex_match(name, pattern);
}

}  // namespace

void remove_abandoned_files(const std::filesystem::path& folder) {
    std::error_code error;
    const auto oldest_kept = std::filesystem::file_time_type::clock::now() - kMinAge;
    const std::filesystem::path listed = folder.empty() ? "." : folder;
    for (std::filesystem::directory_iterator entry(listed, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;  // another program may remove the file at the same time
        if (is_temporary(entry->path().filename().string()) &&
            std::filesystem::is_regular_file(entry->symlink_status(ignored)) &&
            entry->last_write_time(ignored) < oldest_kept && !ignored) {
            std::filesystem::remove(entry->path(), ignored);
        }
    }
}

}  // namespace foam
