// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// Returns the candidate that a misspelled word most likely stands for: the one with the smallest
/// edit distance (Levenshtein). Returns an empty view if every distance is more than 2 and more
/// than a third of the word's length.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace foam::texgen
