// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// Converts a size to Eigen's type of sizes and indices.
inline std::ptrdiff_t signed_size(std::size_t size) {
    return static_cast<std::ptrdiff_t>(size);
}

/// The smallest number of rows for which several threads are used. A smaller system is factored and
/// solved by one thread, and a smaller subtree is solved by one thread, since a second thread would
/// save next to nothing.
inline constexpr std::size_t kMinParallelRows = 3000;

/// One step of the elimination. The pivots are the rows of one part of the dissection. They are
/// eliminated together in a dense matrix, whose rows are the pivots and the border. The border
/// consists of all later rows that are coupled to the pivots. Rows are numbered in the order of
/// elimination.
///
/// The columns of the pivots are the front's panel, which finally holds the front's part of L and
/// D. The Schur complement over the rows and columns of the border is the front's remainder, which
/// is added to the parent front.
struct Front {
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    std::size_t first_row = 0;  // first of the pivots, which are consecutive
    std::size_t pivots = 0;
    std::size_t border = 0;
    std::size_t left = kNone;  // index of the left child front; kNone if this is a leaf
    std::size_t right = kNone;
    // Index of the first front of the subtree. The fronts of a subtree are consecutive, and its
    // root is the last of them.
    std::size_t first_descendant = 0;
    // True if the two subtrees may be processed at the same time, because they share no workspace.
    bool may_fork = false;

    std::size_t border_begin = 0;     // in FrontPlan::border_rows and ::border_slots
    std::size_t panel_begin = 0;      // in the factor
    std::size_t remainder_begin = 0;  // in the workspace
    std::size_t entries_begin = 0;    // in FrontPlan::entries
    std::size_t entries_end = 0;

    std::size_t rows() const { return pivots + border; }
    bool is_leaf() const { return left == kNone; }
};

/// The symbolic factorization, which all matrices of one pattern share.
struct FrontPlan {
    /// An entry of the matrix: its index in the array of values, and its index in the panel of its
    /// front.
    struct Entry {
        std::uint32_t source = 0;
        std::uint32_t target = 0;
    };

    std::vector<std::uint32_t> elimination;   // for each matrix row, its index in the elimination
    std::vector<Front> fronts;                // every front is stored after its children
    std::vector<std::uint32_t> border_rows;   // the borders of all fronts, each in increasing order
    std::vector<std::uint32_t> border_slots;  // slots of these rows in the parent front
    std::vector<Entry> entries;               // sorted by front
    std::size_t panels_size = 0;
    std::size_t workspace_size = 0;
    std::size_t scratch_size = 0;  // per thread
    std::size_t largest_border = 0;

    /// Returns the memory of a factorization on this many threads, in floating-point numbers: the
    /// factor, the remainders of fronts, and the scratch memory of the threads.
    std::size_t memory_size(std::size_t threads) const {
        return panels_size + workspace_size + threads * scratch_size;
    }

    std::span<const std::uint32_t> rows_of_border(const Front& front) const {
        return std::span(border_rows).subspan(front.border_begin, front.border);
    }
    std::span<const std::uint32_t> slots_of_border(const Front& front) const {
        return std::span(border_slots).subspan(front.border_begin, front.border);
    }

    /// Writes the slot of each row of the front to `slot_of_rows`. The slot of a row is its index
    /// in the front's dense matrix: the pivots come first, then the border. Elements of other rows
    /// are not written.
    void write_slots(const Front& front, std::span<std::uint32_t> slot_of_rows) const;
};

}  // namespace foam
