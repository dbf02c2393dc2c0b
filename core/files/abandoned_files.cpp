// SPDX-License-Identifier: Apache-2.0

#include "core/files/abandoned_files.h"

#include <chrono>
#include <string_view>
#include <system_error>

namespace foam {

namespace {

// Longer than any file takes to be written, and than clocks of machines that share a folder differ.
constexpr std::chrono::hours kLongestWrite{24};

// Removes the digits at the end of a text. Returns false if there are none.
bool remove_digits(std::string_view& text) {
    const std::size_t last = text.find_last_not_of("0123456789");
    const std::size_t length = last == std::string_view::npos ? 0 : last + 1;
    const bool has_digits = length < text.size();
    text = text.substr(0, length);
    return has_digits;
}

// Removes the given ending of a text. Returns false if the text ends otherwise.
bool remove_ending(std::string_view& text, std::string_view ending) {
    const bool ends = text.ends_with(ending);
    text.remove_suffix(ends ? ending.size() : 0);
    return ends;
}

// Returns true for names such as NAME.foamtex-123-4.part (unique_sibling in file_io.cpp).
bool is_temporary(std::string_view name) {
    return remove_ending(name, ".part") && remove_digits(name) && remove_ending(name, "-") &&
           remove_digits(name) && remove_ending(name, ".foamtex-") && !name.empty();
}

}  // namespace

void remove_abandoned_files(const std::filesystem::path& folder) {
    std::error_code error;
    const auto oldest = std::filesystem::file_time_type::clock::now() - kLongestWrite;
    const std::filesystem::path listed = folder.empty() ? "." : folder;
    for (std::filesystem::directory_iterator entry(listed, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;  // another program may remove the file at the same time
        if (is_temporary(entry->path().filename().string()) && entry->is_regular_file(ignored) &&
            entry->last_write_time(ignored) < oldest && !ignored) {
            std::filesystem::remove(entry->path(), ignored);
        }
    }
}

}  // namespace foam
