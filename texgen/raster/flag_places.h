#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

inline constexpr std::size_t kFlagsPerWord = 64;

/// How many words hold so many flags.
constexpr std::size_t flag_words(std::size_t flags) {
    return (flags + kFlagsPerWord - 1) / kFlagsPerWord;
}

/// By how many places find_places may write beyond those that it finds.
inline constexpr std::size_t kPlacesBeyond = 32;

/// Writes down where flags are set, in order, and returns how many: bit b of word w is place 64 w +
/// b, below 2^16.
std::size_t find_places(std::span<const std::uint64_t> flags, std::uint16_t* places);

/// The same on any processor.
std::size_t find_places_one_by_one(std::span<const std::uint64_t> flags, std::uint16_t* places);

}  // namespace foam::texgen
