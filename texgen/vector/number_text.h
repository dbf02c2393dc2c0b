// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns a length in millimeters as text with up to nine digits after the decimal point, without
/// trailing zeros and without an exponent. Numbers of at least 1000 have one digit less for each
/// further power of ten. Does not depend on the locale.
std::string length_text(double millimeters);

/// Returns the shortest text from which the same double is read. Does not depend on the locale.
std::string exact_text(double number);

}  // namespace foam::texgen
