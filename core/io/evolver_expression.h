// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/evolver_tokens.h"

#include <map>
#include <string>

namespace foam::evolver {

/// The values that PARAMETER statements of a data file define, by name in lower case.
using Parameters = std::map<std::string, double>;

/// Reads a constant expression and returns its value. The expression consists of numbers,
/// parameters, pi and e, the operators + - * / ^, and parentheses. It may also contain functions of
/// one argument such as sqrt and sin (find_function in evolver_expression.cpp has the list).
/// Outside parentheses, a sign with white space before it and none after it begins the next
/// expression of a list, as in Evolver: `1 -2` is two expressions. Outside parentheses, an operator
/// at the start of a line also ends the expression. Throws FormatError if the expression is
/// missing, malformed or nested too deeply, or if its value is not finite.
double take_expression(TokenReader& tokens, const Parameters& parameters);

}  // namespace foam::evolver
