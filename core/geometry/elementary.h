// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/exponential.h"
#include "core/geometry/trigonometric.h"

/// Elementary functions whose results have the same bits with every compiler, optimization level,
/// instruction set and processor, because they consist of IEEE 754 operations only: addition,
/// subtraction, multiplication, division, square roots, and integer operations. The results of
/// std::sin and the like depend on the C library, which also chooses among several versions at run
/// time. core and texgen therefore use these functions alone; tests/check_layout.py checks it.
///
/// Errors are given in ulp (units in the last place of the exact result). The tests compare with
/// MPFR.
namespace foam::ieee {}
