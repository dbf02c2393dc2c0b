// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_tokens.h"

#include "core/io/format_error.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <limits>
#include <utility>

namespace foam::evolver {

namespace {

// Largest number of characters of a token that an error message quotes.
constexpr std::size_t kMaxQuoted = 40;
// The byte order mark of UTF-8, with which some editors begin a file.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// These functions recognize ASCII only and do not depend on the locale.
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// Returns the value of a number in the locale "C". Unlike std::from_chars, strtod_l also gives a
// value for numbers that are too small or too large for a double.
double parse_in_c_locale(const std::string& text) {
    static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return strtod_l(text.c_str(), nullptr, c_locale);
}

// Returns the value of a number. A number that is too small for a double becomes 0; such numbers
// occur in dumps of Evolver. A number that is too large becomes infinity; a value that is not
// finite is rejected (take_expression, take_integer).
double parse_real(std::string_view text) {
    double value = 0.0;
    const std::from_chars_result result =
        std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() ? value : parse_in_c_locale(std::string(text));
}

// Returns the value of the digits. Returns infinity if the value does not fit into 64 bits or if
// there are no digits.
double parse_hexadecimal(std::string_view digits) {
    std::uint64_t value = 0;
    const std::from_chars_result result =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return result.ec == std::errc() ? static_cast<double>(value)
                                    : std::numeric_limits<double>::infinity();
}

// Returns the token as it is quoted in an error message.
std::string described(const Token& token) {
    if (token.kind == TokenKind::End) {
        return "the end of the file";
    }
    const bool cut = token.text.size() > kMaxQuoted;
    return fmt::format("'{}{}'", token.text.substr(0, kMaxQuoted), cut ? "..." : "");
}

}  // namespace

std::string lower(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

TokenReader::TokenReader(std::string_view text, const std::string& file)
    : text_(text), file_(file) {
    if (text.starts_with(kByteOrderMark)) {
        text_.remove_prefix(kByteOrderMark.size());
    }
    advance();
}

Token TokenReader::take() {
    const Token token = next_;
    advance();
    return token;
}

bool TokenReader::at_word(std::string_view word) const {
    return next_.kind == TokenKind::Word && next_.text.size() == word.size() &&
           lower(next_.text) == word;
}

bool TokenReader::at_integer() const {
    const bool sign = at_symbol('-') || at_symbol('+');
    return sign ? !next_.precedes_space && is_digit(at(0))
                : next_.kind == TokenKind::Number && next_.is_integer;
}

int TokenReader::take_integer(std::string_view meaning) {
    if (!at_integer()) {
        fail_expecting(meaning);
    }
    const bool negative = at_symbol('-');
    if (next_.kind == TokenKind::Symbol) {
        take();
    }
    if (!next_.is_integer || next_.number > std::numeric_limits<int>::max()) {
        fail_expecting(meaning);
    }
    const int value = static_cast<int>(take().number);
    return negative ? -value : value;
}

std::string_view TokenReader::take_word(std::string_view meaning) {
    if (next_.kind != TokenKind::Word) {
        fail_expecting(meaning);
    }
    return take().text;
}

std::string_view TokenReader::take_text(std::string_view meaning) {
    if (next_.kind != TokenKind::Text) {
        fail_expecting(meaning);
    }
    return take().text;
}

void TokenReader::fail(int line, const std::string& message) const {
    throw FormatError(file_, line, message);
}

void TokenReader::fail_expecting(std::string_view meaning) const {
    fail(next_.line, fmt::format("expected {}, found {}", meaning, described(next_)));
}

char TokenReader::at(std::size_t ahead) const {
    return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
}

void TokenReader::advance() {
    next_ = Token();
    next_.follows_space = skip_space();
    next_.line = line_;
    next_.starts_line = std::exchange(line_is_fresh_, false);
    if (position_ == text_.size()) {
        return;
    }
    const std::size_t start = position_;
    if (is_digit(at(0)) || (at(0) == '.' && is_digit(at(1)))) {
        lex_number();
    } else if (is_letter(at(0))) {
        next_.kind = TokenKind::Word;
        while (is_letter(at(0)) || is_digit(at(0))) {
            ++position_;
        }
    } else if (at(0) == '"') {
        lex_text();
        return;
    } else if (at(0) == '#') {
        fail(line_, "preprocessor lines such as #define and #include are not supported");
    } else {
        next_.kind = TokenKind::Symbol;
        ++position_;
    }
    next_.text = text_.substr(start, position_ - start);
    next_.precedes_space = position_ == text_.size() || is_space(at(0));
}

// Skips white space, comments, and backslashes at the ends of lines together with these line ends.
// Returns true if anything was skipped.
bool TokenReader::skip_space() {
    const std::size_t start = position_;
    while (position_ < text_.size()) {
        if (at(0) == '/' && (at(1) == '/' || at(1) == '*')) {
            skip_comment();
        } else if (is_space(at(0))) {
            if (at(0) == '\n') {
                ++line_;
                line_is_fresh_ = true;
            }
            ++position_;
        } else if (!skip_continuation()) {
            break;
        }
    }
    return position_ != start;
}

void TokenReader::skip_comment() {
    if (at(1) == '/') {
        position_ = std::min(text_.find('\n', position_), text_.size());
        return;
    }
    const std::size_t end = text_.find("*/", position_ + 2);
    if (end == std::string_view::npos) {
        fail(line_, "this comment has no closing */");
    }
    const std::string_view comment = text_.substr(position_, end - position_);
    line_ += static_cast<int>(std::count(comment.begin(), comment.end(), '\n'));
    position_ = end + 2;
}

// Skips a backslash at the end of a line, and the line feed. Returns false if there is no such
// backslash.
bool TokenReader::skip_continuation() {
    if (at(0) != '\\') {
        return false;
    }
    std::size_t end = position_ + 1;
    while (end < text_.size() && text_[end] != '\n' && is_space(text_[end])) {
        ++end;
    }
    if (end < text_.size() && text_[end] != '\n') {
        return false;
    }
    ++line_;
    position_ = std::min(end + 1, text_.size());
    return true;
}

void TokenReader::lex_number() {
    const std::size_t start = position_;
    next_.kind = TokenKind::Number;
    const auto skip_digits = [this] {
        while (is_digit(at(0))) {
            ++position_;
        }
    };
    if (at(0) == '0' && (at(1) == 'x' || at(1) == 'X')) {
        position_ =
            std::min(text_.find_first_not_of("0123456789abcdefABCDEF", start + 2), text_.size());
        next_.is_integer = true;
        next_.number = parse_hexadecimal(text_.substr(start + 2, position_ - start - 2));
        return;
    }
    skip_digits();
    next_.is_integer = at(0) != '.';
    if (at(0) == '.') {
        ++position_;
        skip_digits();
    }
    const std::size_t sign = at(1) == '-' || at(1) == '+' ? 1 : 0;
    if ((at(0) == 'e' || at(0) == 'E') && is_digit(at(1 + sign))) {
        next_.is_integer = false;
        position_ += 1 + sign;
        skip_digits();
    }
    next_.number = parse_real(text_.substr(start, position_ - start));
}

void TokenReader::lex_text() {
    next_.kind = TokenKind::Text;
    const std::size_t start = position_ + 1;
    const std::size_t end = text_.find('"', start);
    if (end == std::string_view::npos) {
        fail(line_, "this string has no closing quote");
    }
    next_.text = text_.substr(start, end - start);
    line_ += static_cast<int>(std::count(next_.text.begin(), next_.text.end(), '\n'));
    position_ = end + 1;
    next_.precedes_space = position_ == text_.size() || is_space(at(0));
}

}  // namespace foam::evolver
