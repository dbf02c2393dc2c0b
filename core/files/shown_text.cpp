// SPDX-License-Identifier: Apache-2.0

#include "core/files/shown_text.h"

#include <algorithm>
#include <vector>

namespace foam {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD, the replacement character
constexpr std::string_view kGap = " ... ";

// A character of a text, or a byte that is not part of valid UTF-8 (`is_valid` is false).
struct Character {
    std::string_view bytes;
    char32_t code = 0;  // the code point; 0 if not valid
    bool is_valid = true;
};

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

// Returns the number of bytes of a character of UTF-8 that begins with the given byte. Returns 1,
// too, if no character begins with this byte.
std::size_t length_of_character(unsigned char first) {
    if (first >= 0xf0 && first < 0xf5) {
        return 4;
    }
    if (first >= 0xe0 && first < 0xf0) {
        return 3;
    }
    return first >= 0xc2 && first < 0xe0 ? 2 : 1;
}

// Returns true if a code point must not be encoded in the given number of bytes: it needs fewer
// bytes, is a surrogate, or is beyond Unicode.
bool is_forbidden(char32_t code, std::size_t length) {
    return (length == 3 && code < 0x800) || (length == 4 && code < 0x10000) ||
           (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
}

// Returns the first character of a text. A byte that is not part of valid UTF-8 is a character of
// its own. Precondition: the text is not empty.
Character first_character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) {
        return {text.substr(0, 1), first};
    }
    const std::size_t length = length_of_character(first);
    const std::string_view bytes = text.substr(0, length);
    const std::string_view rest = bytes.substr(1);
    if (length == 1 || bytes.size() < length || !std::ranges::all_of(rest, is_continuation)) {
        return {text.substr(0, 1), 0, false};
    }
    char32_t code = first & (0xffU >> (length + 1));
    for (const char c : rest) {
        code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3fU);
    }
    return is_forbidden(code, length) ? Character{text.substr(0, 1), 0, false}
                                      : Character{bytes, code};
}

std::vector<Character> characters_of(std::string_view text) {
    std::vector<Character> characters;
    while (!text.empty()) {
        characters.push_back(first_character(text));
        text.remove_prefix(characters.back().bytes.size());
    }
    return characters;
}

bool could_control_terminal(char32_t code) {
    const bool is_ascii_control = code < 0x20 || code == 0x7f;
    const bool is_c1_control = code >= 0x80 && code < 0xa0;
    const bool separates_lines = code == 0x2028 || code == 0x2029;
    const bool changes_direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                                   (code >= 0x202a && code <= 0x202e) ||
                                   (code >= 0x2066 && code <= 0x2069);
    return is_ascii_control || is_c1_control || separates_lines || changes_direction;
}

// Returns the bytes that are shown in place of the character.
std::string_view safe_bytes(const Character& character) {
    if (!character.is_valid) {
        return kReplacement;
    }
    if (character.code == '\n' || character.code == '\r' || character.code == '\t') {
        return " ";
    }
    return could_control_terminal(character.code) ? "?" : character.bytes;
}

}  // namespace

bool is_utf8(std::string_view text) {
    return std::ranges::all_of(characters_of(text), &Character::is_valid);
}

bool is_harmless(std::string_view text) {
    return std::ranges::all_of(characters_of(text), [](const Character& character) {
        return character.is_valid && !could_control_terminal(character.code);
    });
}

std::string valid_utf8(std::string_view text) {
    std::string valid;
    for (const Character& character : characters_of(text)) {
        valid += character.is_valid ? character.bytes : kReplacement;
    }
    return valid;
}

std::string shown_text(std::string_view text, std::size_t max_length) {
    const std::vector<Character> characters = characters_of(text);
    const bool is_long = characters.size() > max_length;
    const std::size_t half = (max_length - std::min(max_length, kGap.size())) / 2;
    std::string line;
    for (std::size_t k = 0; k < characters.size(); ++k) {
        if (!is_long || k < half || k >= characters.size() - half) {
            line += safe_bytes(characters[k]);
        } else if (k == half) {
            line += kGap;
        }
    }
    return line;
}

std::string shown_lines(std::string_view text) {
    std::string lines;
    for (const Character& character : characters_of(text)) {
        lines += character.code == '\n' ? "\n" : safe_bytes(character);
    }
    return lines;
}

std::string cut_text(std::string_view text, std::size_t max_length) {
    const std::vector<Character> characters = characters_of(text);
    if (characters.size() <= max_length) {
        return std::string(text);
    }
    const char* const end = characters[max_length].bytes.data();
    return std::string(text.substr(0, static_cast<std::size_t>(end - text.data()))) + "...";
}

}  // namespace foam
