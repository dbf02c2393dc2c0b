#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// Systems and subtrees with fewer rows are processed by one thread: a second one would save next
/// to nothing.
inline constexpr std::size_t kMinParallelRows = 3000;

/// One step of the elimination: the rows of one part of the dissection, the pivots, are eliminated
/// together, in a dense matrix of the pivots and of all later rows that are coupled to them, the
/// border. Rows are numbered in the order of elimination.
///
/// The columns of the pivots are the front's panel, which finally holds its part of L D Lᵀ. The
/// remainder, which is the Schur complement over the rows and columns of the border, is added to
/// the parent front.
struct Front {
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    std::size_t first_row = 0;  // of the pivots, which are consecutive
    std::size_t pivots = 0;
    std::size_t border = 0;
    std::size_t left = kNone;  // the child fronts, both or none
    std::size_t right = kNone;
    std::size_t first_descendant = 0;  // the subtree's fronts begin with it and end with this one
    bool may_fork = false;             // the two subtrees share no memory

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
    /// An entry of the matrix: its index among the matrix' values and its index in the panel of its
    /// front.
    struct Entry {
        std::uint32_t source = 0;
        std::uint32_t target = 0;
    };

    std::vector<std::uint32_t> elimination;   // for each row of the matrix: when it is eliminated
    std::vector<Front> fronts;                // every front after its children
    std::vector<std::uint32_t> border_rows;   // of all fronts, increasing in each
    std::vector<std::uint32_t> border_slots;  // of these rows in the parent front
    std::vector<Entry> entries;               // front after front
    std::size_t panels_size = 0;
    std::size_t workspace_size = 0;
    std::size_t scratch_size = 0;  // of each thread
    std::size_t largest_border = 0;

    /// Returns how many numbers a factorization on this many threads works on: the factor, the
    /// remainders of fronts, and the scratch memory of the threads.
    std::size_t memory_size(std::size_t threads) const {
        return panels_size + workspace_size + threads * scratch_size;
    }

    std::span<const std::uint32_t> rows_of_border(const Front& front) const {
        return std::span(border_rows).subspan(front.border_begin, front.border);
    }
    std::span<const std::uint32_t> slots_of_border(const Front& front) const {
        return std::span(border_slots).subspan(front.border_begin, front.border);
    }

    /// Writes the slot of each of the front's rows, which is its row in the front's dense matrix:
    /// the pivots come first, then the border. Elements of other rows are not written.
    void write_slots(const Front& front, std::span<std::uint32_t> slot_of_rows) const;
};

}  // namespace foam
