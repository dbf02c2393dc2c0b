// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <set>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Converts a name to an identifier of OpenUSD and MaterialX, which consists of ASCII letters,
/// digits and '_', and does not begin with a digit. Each byte that is not one of these characters
/// becomes '_'. A leading digit gets a '_' before it, and an empty name becomes "_".
std::string identifier(std::string_view name);

/// Makes identifiers that differ from each other.
class Identifiers {
  public:
    /// Returns identifier(name), with a number appended if this object has returned it before.
    std::string unique(std::string_view name);

  private:
    std::set<std::string> used_;
};

}  // namespace foam::texgen
