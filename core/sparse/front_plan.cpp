// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_plan.h"

namespace foam {

void FrontPlan::write_slots(const Front& front, std::span<std::uint32_t> slot_of_rows) const {
    std::uint32_t slot = 0;
    for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
        slot_of_rows[front.first_row + pivot] = slot++;
    }
    for (const std::uint32_t row : rows_of_border(front)) {
        slot_of_rows[row] = slot++;
    }
}

}  // namespace foam
