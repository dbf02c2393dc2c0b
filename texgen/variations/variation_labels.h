// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/sheet/contact_sheet.h"
#include "texgen/variations/variation.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the values of a variation in one line: "lloyd=2, seed=7". The names of keys are written
/// without the names of their tables, unless two keys of the variation would have the same name.
std::string label_text(const Variation& variation);

/// Returns the labels for the picture of a variation, one per key. A sheet shows them below the
/// picture. If a value consists of colors, squares of these colors are shown instead of text.
std::vector<ThumbnailLabel> picture_labels(const Variation& variation);

}  // namespace foam::texgen
