// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the candidate that a misspelled word most likely stands for: of the similar candidates,
/// the one with the smallest Levenshtein distance to the word. For a word of n bytes, a candidate
/// is similar if its distance is at most n / 3, or at most 2 if n / 3 is smaller, but never more
/// than n / 2. If no candidate is similar, returns the candidate that begins with the word,
/// provided that the word has at least three bytes and no other candidate begins with it. If there
/// is no such candidate either, returns an empty view.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// Returns the end of an error message that suggests the nearest candidate, such as
/// "; did you mean 'viridis'?". Returns an empty text if `nearest` returns an empty view.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace foam::texgen
