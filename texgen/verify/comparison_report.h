// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/verify/compare_images.h"

#include <span>
#include <string>

namespace foam::texgen {

/// Returns the result of one comparison as a line for users, without a newline.
std::string to_line(const ComparedImage& image);

/// Returns a summary of several comparisons for users. The frames that exist only in A, the first
/// of the two inputs, or only in B, the second, are listed: one line for each map and input. The
/// last line gives the number of images for each verdict.
std::string summary_of(std::span<const ComparedImage> images);

/// Returns all results as one JSON object for programs, with a newline at the end. REPORTS.md
/// describes its members.
std::string to_json(std::span<const ComparedImage> images);

}  // namespace foam::texgen
