// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace foam::evolver {

/// The kinds of tokens.
enum class TokenKind {
    Number,
    Word,
    Text,    // "between quotes"
    Symbol,  // any other character
    End,
};

/// A token of a Surface Evolver data file.
struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;        // the characters in the file, without quotes
    double number = 0.0;          // value of a Number
    bool is_integer = false;      // true for a Number in hexadecimal, or without point and exponent
    int line = 1;                 // line of the file; the first is 1
    bool starts_line = false;     // true for the first token of a line; a line break in a comment
                                  // or a quoted text starts no new line
    bool follows_space = false;   // true if white space or a comment is before the token
    bool precedes_space = false;  // true if white space (not a comment) or the end of the file
                                  // directly follows the token

    bool is_symbol(char symbol) const {
        return kind == TokenKind::Symbol && text.front() == symbol;
    }
};

/// Returns the word in lower case (ASCII only). Keywords of the format are case-insensitive.
std::string lower(std::string_view word);

/// Splits a data file into tokens. Comments count as white space. A backslash at the end of a line
/// continues the line. Throws FormatError if a comment or a quoted text is not closed. Also throws
/// it at a '#' outside of both, because preprocessor lines such as #define are not supported.
class TokenReader {
  public:
    /// `text` is the contents of the data file, `file` its name in error messages. Both must
    /// outlive the reader.
    TokenReader(std::string_view text, const std::string& file);

    /// Returns the next token without consuming it.
    const Token& peek() const { return next_; }
    /// Consumes the next token and returns it. At the end of the text, returns a token of the kind
    /// End.
    Token take();

    /// Returns true if the next token is the given word. The comparison ignores case. Precondition:
    /// `word` is in lower case.
    bool at_word(std::string_view word) const;
    bool at_symbol(char symbol) const { return next_.is_symbol(symbol); }
    bool at_line_start() const { return next_.starts_line; }
    bool at_end() const { return next_.kind == TokenKind::End; }
    /// Returns true if the next token is an integer, or a sign that is directly followed by a
    /// digit.
    bool at_integer() const;

    // Each of these functions consumes the next token and returns its value. take_integer also
    // consumes a sign before the integer. The functions throw FormatError if the token is of
    // another kind, or if the absolute value of the integer is above the largest int. The message
    // says that `meaning` was expected.
    int take_integer(std::string_view meaning);
    std::string_view take_word(std::string_view meaning);
    std::string_view take_text(std::string_view meaning);

    /// Throws FormatError for the given line.
    [[noreturn]] void fail(int line, const std::string& message) const;
    /// Throws FormatError with the message that `meaning` was expected instead of the next token.
    [[noreturn]] void fail_expecting(std::string_view meaning) const;

  private:
    void advance();
    bool skip_space();
    void skip_comment();
    bool skip_continuation();
    void lex_number();
    void lex_text();
    char at(std::size_t ahead) const;

    std::string_view text_;
    const std::string& file_;
    std::size_t position_ = 0;
    int line_ = 1;
    bool line_is_fresh_ = true;  // true if no token of this line has been read
    Token next_;
};

}  // namespace foam::evolver
