#pragma once

#include "core/io/evolver_tokens.h"

#include <map>
#include <string>

namespace foam::evolver {

/// Values of the PARAMETERs of a data file, by their names in lower case.
using Parameters = std::map<std::string, double>;

/// Reads a constant expression: numbers, parameters, pi and e, + - * / ^, parentheses, and the
/// usual functions of one argument. As in Evolver, a sign behind white space with none after it
/// begins the next expression of a list: `1 -2` are two. Throws FormatError where there is none, or
/// where its value is not finite.
double take_expression(TokenReader& tokens, const Parameters& parameters);

}  // namespace foam::evolver
