// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/exponential.h"
#include "core/geometry/trigonometric.h"

/// Elementary functions whose results have the same bits with every compiler, optimization level,
/// instruction set and processor, because they consist only of operations whose results IEEE 754
/// defines (addition, subtraction, multiplication, division, remainder, square root) and of integer
/// operations. The results of std::sin and the like depend on the C library, which may contain
/// several versions of a function and choose one for the processor at run time. core and texgen
/// therefore use only these functions, never std::sin and the like; tests/check_layout.py checks
/// this.
///
/// The comment on each function gives its largest error in ulp (units in the last place of the
/// exact result). The tests compare the results with the library MPFR.
namespace foam::ieee {}
