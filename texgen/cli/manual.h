// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/grammar.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the manual page of a program, section 1, in troff with the macros of man(7). `date` is
/// the date of the version, such as "2026-11-23".
std::string manual_page(const CommandGrammar& program,
                        std::string_view version,
                        std::string_view date);

}  // namespace foam::texgen
