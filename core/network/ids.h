// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace foam {

/// Indices of the network's elements. Each kind of element has its own type of index, so that the
/// compiler rejects an index of another kind.
enum class JunctionId : std::uint32_t {};
enum class FilmId : std::uint32_t {};
enum class BubbleId : std::uint32_t {};
/// The index of a half-edge. Half-edge 2k is the forward side of film k. Half-edge 2k + 1 is the
/// other side of this film and runs in the opposite direction. The tail and the head of the forward
/// side are also called the tail and the head of the film.
enum class HalfEdgeId : std::uint32_t {};

/// The index of kNone. No element has it.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

/// The id that stands for no element.
template <class Id>
inline constexpr Id kNone = static_cast<Id>(kNoIndex);

template <class Id>
constexpr std::size_t index_of(Id id) {
    return static_cast<std::size_t>(id);
}

/// Returns the id with the given index. Precondition: the index is below 2^32.
template <class Id>
constexpr Id id_at(std::size_t index) {
    return static_cast<Id>(static_cast<std::uint32_t>(index));
}

/// Returns the other half-edge of the same film.
constexpr HalfEdgeId twin(HalfEdgeId h) {
    return id_at<HalfEdgeId>(index_of(h) ^ 1U);
}
constexpr FilmId film_of(HalfEdgeId h) {
    return id_at<FilmId>(index_of(h) >> 1U);
}
constexpr HalfEdgeId forward_side(FilmId film) {
    return id_at<HalfEdgeId>(index_of(film) << 1U);
}
constexpr bool is_forward(HalfEdgeId h) {
    return (index_of(h) & 1U) == 0U;
}

}  // namespace foam
