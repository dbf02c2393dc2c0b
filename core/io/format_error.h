// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdexcept>
#include <string>

namespace foam {

/// The error that all readers of this library throw if a file does not conform to its format, or
/// does not describe a valid foam. The result of what() is "file:line: message"; the message is one
/// line of printable ASCII.
class FormatError : public std::runtime_error {
  public:
    FormatError(const std::string& file, int line, const std::string& message);

    /// Returns the number of the line; the first line is 1.
    int line() const { return line_; }

  private:
    int line_;
};

}  // namespace foam
