#pragma once

#include <string>
#include <string_view>

namespace foam::evolver {

enum class TokenKind {
    Number,
    Word,
    Text,    // "between quotes"
    Symbol,  // any other character
    End,
};

/// A piece of a Surface Evolver data file.
struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;    // as in the file, quotes not included
    double number = 0.0;      // of a Number
    bool is_integer = false;  // a Number without point and exponent, or a hexadecimal one
    int line = 1;
    bool starts_line = false;
    bool follows_space = false;
    bool precedes_space = false;

    bool is_symbol(char symbol) const {
        return kind == TokenKind::Symbol && text.front() == symbol;
    }
};

/// Lower case; words of the format have none of their own.
std::string lower(std::string_view word);

/// Takes a data file apart. Comments and backslashes at the ends of lines are white space. What is
/// malformed throws FormatError with the line.
class TokenReader {
  public:
    /// Both have to outlive the reader.
    TokenReader(std::string_view text, const std::string& file);

    const Token& peek() const { return next_; }
    Token take();

    /// Whether the next token is this word, given in lower case.
    bool at_word(std::string_view word) const;
    bool at_symbol(char symbol) const { return next_.is_symbol(symbol); }
    bool at_line_start() const { return next_.starts_line; }
    bool at_end() const { return next_.kind == TokenKind::End; }
    /// Whether an integer comes next, with a sign before it or none.
    bool at_integer() const;

    /// `meaning` says in an error what was expected.
    int take_integer(std::string_view meaning);
    std::string_view take_word(std::string_view meaning);
    std::string_view take_text(std::string_view meaning);

    [[noreturn]] void fail(int line, const std::string& message) const;
    /// That something else was expected than what comes next.
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
    bool line_is_fresh_ = true;  // no token of this line has been read
    Token next_;
};

}  // namespace foam::evolver
