// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/sheet/contact_sheet.h"
#include "texgen/variations/variation.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the values of a variation in one line: "lloyd=2, seed=7". The table of a key is left
/// out, unless the variation has two keys of the same name.
std::string label_text(const Variation& variation);

/// Returns the labels of a variation below its picture, one per key. Values that are colors are
/// shown as colors.
std::vector<ThumbnailLabel> picture_labels(const Variation& variation);

}  // namespace foam::texgen
