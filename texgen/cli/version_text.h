// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns the text of `foamtex --version`: the version and the licenses. A detailed text also has
/// the facts that a bug report needs:
/// - the version of the algorithms on which pixels depend (kAlgorithmVersion)
/// - the commit from which the program was built
/// - the compiler, the type of the build, and the versions of the libraries
/// - the instruction sets in use and available (SimdLevel)
/// - the number of threads
///
/// A detailed text throws as simd_level does.
std::string version_text(bool is_detailed);

}  // namespace foam::texgen
