// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns a length in millimeters as text with up to nine digits after the decimal point, without
/// trailing zeros and without an exponent. Longer lengths have fewer digits: at most eight from
/// 1000 on, one less for each further power of ten, and none from 10^11 on. Does not depend on the
/// locale.
std::string length_text(double millimeters);

/// Returns the shortest text from which the same double is read. Does not depend on the locale.
std::string exact_text(double number);

}  // namespace foam::texgen
