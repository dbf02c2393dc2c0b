// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/existing_sequence.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace foam::texgen {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::filesystem::path file_of_frame(const FilePattern& pattern, int frame) {
    return pattern.path({}, frame);
}

/// Returns the number of the frame whose file has the given path, or nullopt if the pattern gives
/// this path to no frame. Tries all numbers that occur in the text of the path.
std::optional<int> frame_of(const FilePattern& pattern, const std::filesystem::path& path) {
    const std::string text = path.string();
    for (auto begin = text.begin(); begin != text.end(); ++begin) {
        const auto last = std::find_if_not(begin, text.end(), is_digit);
        for (auto end = last; end != begin; --end) {
            int frame = 0;
            const std::string_view digits(begin, end);
            const auto [rest, error] =
                std::from_chars(digits.data(), digits.data() + digits.size(), frame);
            if (error == std::errc() &&
                file_of_frame(pattern, frame).lexically_normal() == path.lexically_normal()) {
                return frame;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::map<int, std::filesystem::path> existing_sequence(const FilePattern& pattern) {
    namespace fs = std::filesystem;
    std::map<int, fs::path> files;
    const fs::path folder = pattern.folder();
    // If the pattern has the frame number in the name of a folder, the files are in subfolders of
    // `folder`.
    const bool is_flat = file_of_frame(pattern, 1).parent_path() == folder;
    std::error_code missing;
    fs::recursive_directory_iterator entry(folder.empty() ? "." : folder, missing);
    for (; entry != fs::recursive_directory_iterator(); ++entry) {
        if (entry->is_directory() && is_flat) {
            entry.disable_recursion_pending();
        }
        const std::optional<int> frame = frame_of(pattern, entry->path());
        if (frame && !entry->is_directory()) {
            files.emplace(*frame, file_of_frame(pattern, *frame));
        }
    }
    return files;
}

}  // namespace foam::texgen
