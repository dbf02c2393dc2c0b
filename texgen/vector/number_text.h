// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns a length in millimeters as text with up to nine digits after the decimal point, without
/// trailing zeros and without an exponent. From 1000 on, there is one digit less for each power of
/// ten: at most eight digits from 1000 on, at most seven from 10,000 on, and none from 10^11 on.
/// Does not depend on the locale.
std::string length_text(double millimeters);

/// Returns the shortest text from which the same double is read. Does not depend on the locale.
std::string exact_text(double number);

}  // namespace foam::texgen
