#pragma once

#include "core/geometry/domain.h"
#include "core/io/evolver_expression.h"
#include "core/io/evolver_tokens.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// What the top of a data file says about the whole foam.
struct Header {
    Domain domain;  // the plane for a free cluster
    Parameters parameters;
    double added_tension = 0.0;      // of every film, by named quantities of its length
    std::vector<std::string> notes;  // what was left out, one line each
};

/// Reads up to the section of the vertices. What does not bear on a foam's equilibrium is passed
/// over. Throws FormatError where the file is no string model in the plane or on a torus whose
/// first period lies along x, and where it adds an energy that a foam has not.
Header read_header(TokenReader& tokens);

}  // namespace foam::evolver
