#pragma once

#include "texgen/cli/grammar.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// The manual page of a program, section 1, as troff with the macros of man(7).
std::string manual_page(const CommandGrammar& program, std::string_view version);

}  // namespace foam::texgen
