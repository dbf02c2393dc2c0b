// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// Returns the size as a signed number, the type of Eigen's sizes and indices.
inline std::ptrdiff_t signed_size(std::size_t size) {
    return static_cast<std::ptrdiff_t>(size);
}

/// The smallest number of rows for which several threads are used. A system with fewer rows is
/// factored and solved on one thread, since a second thread would save next to nothing. In a larger
/// system, each subtree of the tree of fronts that has fewer rows is solved on one thread.
inline constexpr std::size_t kMinParallelRows = 3000;

/// A front: one step of the elimination. Its pivots are the rows of one DissectionPart
/// (dissection.h): of a separator, or of a part of the graph that is not divided. They are
/// eliminated together in a dense matrix, whose rows are the pivots and the border. The border
/// consists of all later rows that are coupled to the pivots, directly or through rows that were
/// eliminated earlier. Rows are numbered in the order of elimination.
///
/// The columns of the pivots are the front's panel, stored column by column. After the elimination,
/// the panel holds the front's part of L and D. The Schur complement over the rows and columns of
/// the border is the front's update matrix. It is added to the parent front.
struct Front {
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    std::size_t first_row = 0;  // first of the pivots, which are consecutive
    std::size_t pivots = 0;     // number of pivots
    std::size_t border = 0;     // number of rows of the border
    std::size_t left = kNone;   // index of the left child front; kNone if this is a leaf
    std::size_t right = kNone;  // the same for the right child front
    // Index of the first front of the subtree of which this front is the root. The fronts of a
    // subtree are consecutive, and its root is the last of them.
    std::size_t first_descendant = 0;
    // True if the two subtrees may be processed at the same time, because they share no workspace.
    bool may_fork = false;

    // Indices at which the data of the front begin.
    std::size_t border_begin = 0;   // in FrontPlan::border_rows and ::border_slots
    std::size_t panel_begin = 0;    // in the factor
    std::size_t update_begin = 0;   // in the workspace
    std::size_t entries_begin = 0;  // in FrontPlan::entries
    std::size_t entries_end = 0;    // index after the front's last entry

    std::size_t rows() const { return pivots + border; }
    bool is_leaf() const { return left == kNone; }
};

/// The symbolic factorization, which is the same for all matrices of one pattern.
struct FrontPlan {
    /// An entry of the matrix: `source` is its index in the matrix's array of values, `target` its
    /// index in the panel of its front.
    struct Entry {
        std::uint32_t source = 0;
        std::uint32_t target = 0;
    };

    std::vector<std::uint32_t> position_of_row;  // for each row, its index in the order of
                                                 // elimination
    std::vector<Front> fronts;                   // every front is stored after its children
    std::vector<std::uint32_t> border_rows;   // the borders of all fronts, each in increasing order
    std::vector<std::uint32_t> border_slots;  // their slots in the parent front (see write_slots)
    std::vector<Entry> entries;               // sorted by front
    // Sizes of memory, in floating-point numbers.
    std::size_t panels_size = 0;     // all panels: the factor
    std::size_t workspace_size = 0;  // the update matrices of fronts
    std::size_t scratch_size = 0;    // per thread

    std::size_t largest_border = 0;  // largest number of rows of a border

    /// Returns the memory of a factorization on the given number of threads, in floating-point
    /// numbers. This memory holds the factor, the update matrices of fronts, and the scratch memory
    /// of the threads.
    std::size_t memory_size(std::size_t threads) const {
        return panels_size + workspace_size + threads * scratch_size;
    }

    /// Returns the rows of the border of a front, in increasing order.
    std::span<const std::uint32_t> rows_of_border(const Front& front) const {
        return std::span(border_rows).subspan(front.border_begin, front.border);
    }
    /// Returns the slots (write_slots) of the rows of the border in the parent front.
    std::span<const std::uint32_t> slots_of_border(const Front& front) const {
        return std::span(border_slots).subspan(front.border_begin, front.border);
    }

    /// Writes the slot of each row of the front to `slot_of_rows`. The slot of a row is its index
    /// in the front's dense matrix: the pivots come first, then the border. Elements of other rows
    /// are not written.
    void write_slots(const Front& front, std::span<std::uint32_t> slot_of_rows) const;
};

}  // namespace foam
