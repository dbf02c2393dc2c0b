#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// Returns the candidate that was most likely meant by a misspelled word: the one with the smallest
/// edit distance, or an empty view if none is within a third of the word's length, or 2 if that is
/// more.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace foam::texgen
