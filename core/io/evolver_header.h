// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/io/evolver_expression.h"
#include "core/io/evolver_tokens.h"

#include <string>
#include <vector>

namespace foam::evolver {

/// The top section of a data file of Surface Evolver. It applies to the whole foam.
struct Header {
    Domain domain;  // the plane for a free cluster
    Parameters parameters;
    // The tension that the energies in the file add to the film tension. Each energy is the total
    // length of all edges times a factor: the modulus of the energy times the sum of the moduli of
    // its methods. The added tension is the sum of these factors.
    double added_tension = 0.0;
    std::vector<std::string> notes;  // remarks on ignored statements, one line each
};

/// Reads and returns the top section. The next token is then the keyword of the section of
/// vertices. Ignores quantities that are not energies; adds a note if they are fixed or conserved.
/// Also ignores all other statements, except those that README.md lists as rejected. Throws
/// FormatError in these cases:
/// - the file is not a string model in the plane or on a torus whose first period is along x;
/// - the width or the height of the torus is not positive, or they differ too much
///   (has_moderate_shape);
/// - the magnitude of the shear is more than 1e6 widths;
/// - the file adds an energy other than the length of all edges;
/// - the file has a statement that README.md lists as rejected;
/// - a statement is malformed, or the file has no section of vertices.
Header read_header(TokenReader& tokens);

}  // namespace foam::evolver
