// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace foam::texgen {

/// Reads the numbers, flags and letters of an attribute of an SVG, such as the data of a path.
/// Spaces and commas before an item are skipped.
class SvgText {
  public:
    explicit SvgText(std::string_view text) : text_(text) {}

    /// Returns true if nothing but spaces and commas is left.
    bool is_at_end();
    /// Returns the position of the next character, counted from 1.
    std::size_t position() const { return index_ + 1; }

    /// Returns the next letter and skips it, or nullopt if the next character is no letter.
    std::optional<char> letter();
    /// Returns the next word of letters, which may be empty, and skips it.
    std::string_view word();
    /// Skips the character if it is next. Returns true if it was.
    bool skip(char c);
    /// Returns the next number and skips it, or nullopt if there is none or if its magnitude is
    /// above 1e9.
    std::optional<double> number();
    /// Returns the next flag, '0' or '1', and skips it, or nullopt if there is none. A flag needs
    /// no space after it.
    std::optional<bool> flag();

  private:
    void skip_spaces();

    std::string_view text_;
    std::size_t index_ = 0;
};

}  // namespace foam::texgen
