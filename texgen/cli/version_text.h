// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns the text of `foamtex --version`: the version and the licenses. A detailed text also has
/// the version of the algorithms on which
/// pixels depend (kAlgorithmVersion), the commit from which the program was built, the compiler,
/// the versions of the libraries, and the instruction set in use (SimdLevel). Reports about faults
/// need them. Throws as simd_level does.
std::string version_text(bool is_detailed);

}  // namespace foam::texgen
