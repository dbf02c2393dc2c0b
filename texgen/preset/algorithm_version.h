// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The version of the algorithms on which pixels depend. As long as it is the same, a preset and a
/// seed give the same pixels with every version of foamtex. A commit that changes a pixel of a
/// shipped preset or of a map increments this number, and adds a line to the table "Changes of
/// pixels" of CHANGELOG.md, unless the latest release has a lower number already.
inline constexpr int kAlgorithmVersion = 1;

}  // namespace foam::texgen
