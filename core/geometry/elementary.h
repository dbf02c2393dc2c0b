// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/exponential.h"
#include "core/geometry/trigonometric.h"

/// Elementary functions whose results have the same bits with every compiler, optimization level,
/// instruction set and processor. They consist only of integer operations and of operations whose
/// results IEEE 754 defines: addition, subtraction, multiplication, division, remainder and square
/// root. The results of std::sin and similar functions depend on the C library. The library may
/// choose one of several versions of a function for the processor at run time. Therefore core and
/// texgen use only the functions of this namespace. The test tests/check_layout.py checks that they
/// do not use std::sin and similar functions.
///
/// The comment on each function gives its largest error in ulp (units in the last place of the
/// exact result). The tests compare the results with the library MPFR.
namespace foam::ieee {}
