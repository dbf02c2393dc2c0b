// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace foam {

/// The largest number of characters of a message.
inline constexpr std::size_t kMaxMessageLength = 2000;
/// The largest number of characters of a value that a message quotes.
inline constexpr std::size_t kMaxQuoteLength = 60;

/// Returns true if the text is valid UTF-8.
bool is_utf8(std::string_view text);

/// Returns true if the text is valid UTF-8 without any character that could control a terminal.
/// Such characters are control characters, separators of lines, and characters that change the
/// direction of writing.
bool is_harmless(std::string_view text);

/// Returns a text in which every byte that is not UTF-8 is replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// Returns a text as one line of valid UTF-8 that a terminal shows without interpreting any
/// character:
/// - a line feed, a carriage return or a tab becomes a space;
/// - every other character that could control a terminal becomes a question mark;
/// - every byte that is not UTF-8 becomes U+FFFD.
///
/// If the text has more than `max_length` characters, its middle is replaced by " ... ". The
/// beginning of an error message, which says where the error is, and its end, which gives the
/// reason, are then kept.
std::string shown_text(std::string_view text, std::size_t max_length = kMaxMessageLength);

/// Returns a text in which the same characters and bytes are replaced as in the result of
/// shown_text, except line feeds, which are kept. The length is not limited.
std::string shown_lines(std::string_view text);

/// Returns the text if it has at most `max_length` characters. Otherwise returns its first
/// `max_length` characters, followed by "...".
std::string cut_text(std::string_view text, std::size_t max_length = kMaxQuoteLength);

}  // namespace foam
