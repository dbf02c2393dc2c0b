// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/verify/compare_images.h"

#include <span>
#include <string>

namespace foam::texgen {

/// Returns the result of one comparison as a line for users, without a newline.
std::string to_line(const ComparedImage& image);

/// Returns a summary of several comparisons for users. It lists the frames that exist only in the
/// first input, A, or only in the second input, B. There is one line for each map and input. The
/// last line of the summary gives the number of images for each verdict.
std::string summary_of(std::span<const ComparedImage> images);

/// Returns all results as one JSON object for programs, with a newline at the end. REPORTS.md
/// describes its members.
std::string to_json(std::span<const ComparedImage> images);

}  // namespace foam::texgen
