// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The version of the algorithms on which pixels depend. As long as it is the same, a preset and a
/// seed give the same pixels with every version of foamtex. A commit that changes a pixel of a
/// shipped preset or of a map adds a line to the table "Changes of pixels" of CHANGELOG.md. After a
/// release, the first such commit also increments this number. (There has been no release.)
inline constexpr int kAlgorithmVersion = 1;

}  // namespace foam::texgen
