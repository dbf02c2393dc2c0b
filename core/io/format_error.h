#pragma once

#include <stdexcept>
#include <string>

namespace foam {

/// A file that does not hold what its format asks for, or what a foam needs. what() is one line,
/// "file:line: message".
class FormatError : public std::runtime_error {
  public:
    FormatError(const std::string& file, int line, const std::string& message);

    int line() const { return line_; }  // the first is 1

  private:
    int line_;
};

}  // namespace foam
