// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_entries.h"

#include "core/geometry/narrow.h"

#include <algorithm>
#include <cassert>

namespace foam {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Calls action(entry, column, row) for each entry of the matrix. `entry` is the index of the entry
// in storage order. `column` and `row` are its column and its row in the order of elimination, with
// row ≥ column.
template <class Action>
void each_entry(const Matrix& lower, const FrontPlan& plan, const Action& action) {
    std::size_t entry = 0;
    for (Eigen::Index column = 0; column < lower.cols(); ++column) {
        const std::uint32_t a = plan.position_of_row[static_cast<std::size_t>(column)];
        for (Matrix::InnerIterator at(lower, column); at; ++at, ++entry) {
            const std::uint32_t b = plan.position_of_row[static_cast<std::size_t>(at.row())];
            action(entry, std::min(a, b), std::max(a, b));
        }
    }
}

// Columns are numbered in the order of elimination. Returns, for entries sorted by column, the
// index of the first entry of each column, followed by the number of all entries.
std::vector<std::size_t> begins_of_columns(const Matrix& lower, const FrontPlan& plan) {
    std::vector<std::size_t> begins(plan.position_of_row.size() + 1, 0);
    each_entry(lower, plan, [&](std::size_t, std::uint32_t column, std::uint32_t) {
        ++begins[column + 1];
    });
    for (std::size_t column = 0; column + 1 < begins.size(); ++column) {
        begins[column + 1] += begins[column];
    }
    return begins;
}

// Returns the entries sorted by column. `next_of_columns` is the result of begins_of_columns.
// `Entry::target` does not have its final value yet: it is the row of the entry in the order of
// elimination.
std::vector<FrontPlan::Entry> sorted_entries(const Matrix& lower,
                                             const FrontPlan& plan,
                                             std::vector<std::size_t> next_of_columns) {
    std::vector<FrontPlan::Entry> entries(static_cast<std::size_t>(lower.nonZeros()));
    each_entry(lower, plan, [&](std::size_t entry, std::uint32_t column, std::uint32_t row) {
        entries[next_of_columns[column]++] = {narrow(entry), row};
    });
    return entries;
}

}  // namespace

void locate_entries(const Matrix& lower_pattern, FrontPlan& plan) {
    assert(lower_pattern.isCompressed());
    const std::vector<std::size_t> begins = begins_of_columns(lower_pattern, plan);
    plan.entries = sorted_entries(lower_pattern, plan, begins);
    std::vector<std::uint32_t> slots(plan.position_of_row.size());
    for (Front& front : plan.fronts) {
        plan.write_slots(front, slots);
        front.entries_begin = begins[front.first_row];
        front.entries_end = begins[front.first_row + front.pivots];
        for (std::size_t column = 0; column < front.pivots; ++column) {
            const std::size_t row = front.first_row + column;
            for (std::size_t k = begins[row]; k < begins[row + 1]; ++k) {
                std::uint32_t& target = plan.entries[k].target;
                target = narrow(column * front.rows() + slots[target]);
            }
        }
    }
}

}  // namespace foam
