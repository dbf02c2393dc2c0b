#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// The candidate that a slip of the keyboard most likely turned into `word`: the one with the
/// smallest edit distance, or an empty view where none lies within a third of the word's length (or
/// 2).
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace foam::texgen
