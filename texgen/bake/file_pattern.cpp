// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/file_pattern.h"

#include "texgen/image/file_suffix.h"
#include "texgen/image/format.h"
#include "texgen/preset/placeholder.h"
#include "texgen/vector/format.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kSpecial = "{#@%";

std::string_view take(std::string_view& rest, std::size_t count) {
    const std::string_view taken = rest.substr(0, count);
    rest.remove_prefix(taken.size());
    return taken;
}

// Removes the first character and the equal characters that follow it, and returns them.
std::string_view take_repeated(std::string_view& rest) {
    return take(rest, rest.find_first_not_of(rest.front()));
}

// Returns the position of the first '.' in the file name that is outside of braces and is not the
// first character of the file name. Precondition: the file name has a suffix.
std::size_t first_period(std::string_view pattern) {
    std::size_t position = pattern.find_last_of('/') + 1;
    if (pattern[position] != '{') {
        ++position;
    }
    while (pattern[position] != '.') {
        position = pattern[position] == '{' ? pattern.find('}', position) : position + 1;
        position = std::min(position, pattern.rfind('.'));
    }
    return position;
}

// Returns the pattern, with "_{map}" inserted if the pattern ends in .csv and has no {map}. In this
// format, a frame consists of several tables, each in a file of its own.
std::string with_table(std::string_view pattern) {
    std::string complete(pattern);
    if (has_suffix(pattern, ".csv") && pattern.find("{map}") == std::string_view::npos) {
        complete.insert(first_period(pattern), "_{map}");
    }
    return complete;
}

// Returns the position in a pattern after the folders that the files of all maps and frames share.
std::size_t end_of_shared_folders(std::string_view pattern) {
    const std::size_t varying = std::min(pattern.find("{map}"), pattern.find_first_of("#@%"));
    const std::size_t slash = pattern.substr(0, varying).rfind('/');
    return slash == std::string_view::npos ? 0 : slash + 1;
}

std::string padded(int number, int digits) {
    return fmt::format("{:0{}}", number, digits);
}

}  // namespace

FilePattern::FilePattern(const Preset& preset)
    : FilePattern(preset.output.pattern,
                  [&](std::string_view name) { return placeholder_text(preset, name); }) {}

FilePattern::FilePattern(std::string_view pattern)
    : FilePattern(pattern, [](std::string_view name) -> std::string {
          throw std::invalid_argument(
              fmt::format("unknown placeholder '{{{}}}'; must be {{map}}", name));
      }) {}

FilePattern::FilePattern(std::string_view pattern, const Placeholders& placeholders)
    : pattern_(pattern), format_(find_format(pattern)) {
    if (format_ == nullptr && find_vector_format(pattern) == nullptr) {
        reject(fmt::format("must end in {}, or in {}; an example is 'x/{{map}}.####.png'",
                           format_suffixes(),
                           vector_suffixes()));
    }
    const std::string complete = with_table(pattern);
    for (std::string_view rest = complete; !rest.empty();) {
        pieces_.push_back(take_piece(rest, placeholders));
    }
}

FilePattern::Piece FilePattern::take_piece(std::string_view& rest,
                                           const Placeholders& placeholders) const {
    switch (rest.front()) {
        case '{':
            return take_word(rest, placeholders);
        case '%':
            return take_format(rest);
        case '#': {
            const std::string_view digits = take_repeated(rest);
            return FrameNumber{digits.size() == 1 ? 4 : static_cast<int>(digits.size()),
                               std::string(digits)};
        }
        case '@': {
            const std::string_view digits = take_repeated(rest);
            return FrameNumber{static_cast<int>(digits.size()), std::string(digits)};
        }
        default:
            return std::string(take(rest, rest.find_first_of(kSpecial)));
    }
}

FilePattern::Piece FilePattern::take_word(std::string_view& rest,
                                          const Placeholders& placeholders) const {
    const std::size_t brace = rest.find('}');
    if (brace == std::string_view::npos) {
        reject(fmt::format("'{}' has no closing brace", rest));
    }
    const std::string_view word = take(rest, brace + 1);
    if (word == "{map}") {
        return MapName{};
    }
    try {
        return placeholders(word.substr(1, word.size() - 2));
    } catch (const std::invalid_argument& error) {
        reject(error.what());
    }
}

FilePattern::Piece FilePattern::take_format(std::string_view& rest) const {
    const std::string_view format = take(rest, rest.find('d') + 1);
    if (format == "%d") {
        return FrameNumber{1, "%d"};
    }
    const bool padded = format.size() == 4 && format[1] == '0' &&
                        std::isdigit(static_cast<unsigned char>(format[2])) != 0;
    if (!padded) {
        reject("'%' must be followed by d, or by 0, one digit and d, as in %04d");
    }
    return FrameNumber{format[2] - '0', std::string(format)};
}

void FilePattern::reject(std::string_view reason) const {
    throw std::invalid_argument(fmt::format("file name pattern '{}': {}", pattern_, reason));
}

template <class Alternative>
bool FilePattern::has() const {
    return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& piece) {
        return std::holds_alternative<Alternative>(piece);
    });
}

bool FilePattern::stores_all_maps_in_one_file() const {
    return !is_vector() && format_->has_layers && !has<MapName>();
}

void FilePattern::check_distinct(std::size_t frames, std::size_t maps) const {
    if (frames > 1 && !has<FrameNumber>()) {
        reject(
            fmt::format("must contain a frame number (####, @@@@ or %04d) for {} frames", frames));
    }
    if (maps > 1 && !has<MapName>() && !stores_all_maps_in_one_file()) {
        reject(fmt::format("must contain {{map}} for {} maps", maps));
    }
}

std::filesystem::path FilePattern::path(std::string_view map, int frame) const {
    return fill(map, frame);
}

std::filesystem::path FilePattern::folder() const {
    std::string filled;
    for (const Piece& piece : pieces_) {
        if (const auto* text = std::get_if<std::string>(&piece)) {
            filled += *text;
        } else {
            filled += '_';  // represents any map name or frame number
            break;
        }
    }
    return std::filesystem::path(filled).parent_path();
}

std::string FilePattern::path_pattern(std::string_view map) const {
    return fill(map, std::nullopt);
}

std::string FilePattern::fill(std::string_view map, std::optional<int> frame) const {
    std::string filled;
    for (const Piece& piece : pieces_) {
        if (const auto* text = std::get_if<std::string>(&piece)) {
            filled += *text;
        } else if (const auto* number = std::get_if<FrameNumber>(&piece)) {
            filled += frame ? padded(*frame, number->digits) : number->written;
        } else {
            filled += map;
        }
    }
    return filled;
}

std::string with_size_folder(std::string_view pattern) {
    constexpr std::string_view kSize = "{size}";
    std::string complete(pattern);
    if (pattern.find(kSize) == std::string_view::npos) {
        complete.insert(end_of_shared_folders(pattern), fmt::format("{}/", kSize));
    }
    return complete;
}

std::string without_shared_folders(std::string_view pattern) {
    return std::string(pattern.substr(end_of_shared_folders(pattern)));
}

}  // namespace foam::texgen
