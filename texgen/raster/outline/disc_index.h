// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace foam::texgen {

/// A circle and its inside.
struct Disc {
    Vec2 center{0.0, 0.0};
    double radius = 0.0;
};

/// Finds the discs of a set that may be near a disc. Sets of more than kFewDiscs discs are stored
/// in an R-tree; a search in smaller sets returns all discs. Buffers are reused.
class DiscIndex {
  public:
    static constexpr std::size_t kFewDiscs = 64;

    DiscIndex();
    ~DiscIndex();
    DiscIndex(const DiscIndex&) = delete;
    DiscIndex& operator=(const DiscIndex&) = delete;

    /// Replaces the set by the discs disc_at(0), ..., disc_at(count - 1).
    template <class DiscAt>
    void build(std::size_t count, const DiscAt& disc_at) {
        discs_.clear();
        for (std::size_t k = 0; count > kFewDiscs && k < count; ++k) {
            discs_.push_back(disc_at(k));
        }
        build_tree(count);
    }

    /// Returns, in ascending order, the indices of all discs that have a point in common with the
    /// given disc, and possibly of some that have none. The result is valid until the next call.
    std::span<const std::size_t> near(const Disc& disc);

  private:
    class Tree;

    void build_tree(std::size_t count);

    std::vector<Disc> discs_;       // empty if there are at most kFewDiscs discs
    std::vector<std::size_t> all_;  // all indices if there are at most kFewDiscs discs
    std::unique_ptr<Tree> tree_;
    std::vector<std::size_t> found_;
};

}  // namespace foam::texgen
