// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/io/evolver_expression.h"
#include "core/io/evolver_tokens.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// The top section of a data file, which applies to the whole foam.
struct Header {
    Domain domain;  // the plane for a free cluster
    Parameters parameters;
    double added_tension = 0.0;      // sum of the energies per length of all edges
    std::vector<std::string> notes;  // statements that were dropped, one line each
};

/// Reads the top section, up to the section of the vertices. Ignores statements that do not affect
/// the equilibrium of a foam. Throws FormatError if the file is not a string model in the plane or
/// on a torus whose first period is along x, or if it adds an energy that this model does not have.
Header read_header(TokenReader& tokens);

}  // namespace foam::evolver
