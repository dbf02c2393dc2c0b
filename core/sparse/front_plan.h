#pragma once

#include "core/sparse/dissection.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foam {

/// One step of the elimination: the rows of one part of the dissection, the pivots, are eliminated
/// at once, in a dense matrix of the pivots and of all later rows that are coupled to them, the
/// border. Rows are counted in the order of elimination.
///
/// The pivots' columns are the front's panel and hold its share of L D Lᵀ in the end. What remains
/// of the border's rows and columns goes into the parent front.
struct Front {
    std::size_t first_row = 0;  // of the pivots, which follow each other
    std::size_t pivots = 0;
    std::size_t border = 0;
    std::size_t left = DissectionPart::kNoPart;  // the fronts below, both or none
    std::size_t right = DissectionPart::kNoPart;
    std::size_t first_descendant = 0;  // the subtree's fronts begin with it and end with this one
    bool may_fork = false;             // the two subtrees share no memory

    // Where the front's own begins ...
    std::size_t border_begin = 0;     // ... in FrontPlan::border_rows and ::border_places
    std::size_t panel_begin = 0;      // ... among the panels
    std::size_t remainder_begin = 0;  // ... in the workspace
    std::size_t entries_begin = 0;    // ... and ends in FrontPlan::entries
    std::size_t entries_end = 0;

    std::size_t rows() const { return pivots + border; }
    bool is_leaf() const { return left == DissectionPart::kNoPart; }
};

/// What the factorizations of all matrices of one pattern have in common.
struct FrontPlan {
    /// A number of the matrix: its place among the matrix' values and in its front's panel.
    struct Entry {
        std::uint32_t source = 0;
        std::uint32_t place = 0;
    };

    std::vector<std::uint32_t> elimination;    // of each row of the matrix: when it is eliminated
    std::vector<Front> fronts;                 // every front after those below it
    std::vector<std::uint32_t> border_rows;    // of all fronts, increasing in each
    std::vector<std::uint32_t> border_places;  // of these rows: place in the parent front
    std::vector<Entry> entries;                // front after front
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
    std::span<const std::uint32_t> places_of_border(const Front& front) const {
        return std::span(border_places).subspan(front.border_begin, front.border);
    }

    /// Writes the place of each of the front's rows within the front, and leaves other rows alone.
    void write_places(const Front& front, std::span<std::uint32_t> place_of_rows) const;
};

/// Plans the factorization of matrices whose lower triangle has the given pattern, compressed and
/// with its columns in order. The nodes take up the rows in turn. Returns nothing if the factor and
/// the remainders of fronts would take more numbers than `limit`.
std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const Domain& domain,
                                     const DissectionOptions& options,
                                     std::size_t limit,
                                     int threads = 1);

}  // namespace foam
