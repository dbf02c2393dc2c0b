// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/evolver_tokens.h"

#include <map>
#include <string>

namespace foam::evolver {

/// The values of the PARAMETERs of a data file, by name in lower case.
using Parameters = std::map<std::string, double>;

/// Reads a constant expression: numbers, parameters, pi and e, + - * / ^, parentheses, and the
/// usual functions of one argument. As in Evolver, a sign with white space before it and none after
/// it begins the next expression of a list: `1 -2` is two expressions. Throws FormatError if there
/// is no expression or if its value is not finite.
double take_expression(TokenReader& tokens, const Parameters& parameters);

}  // namespace foam::evolver
