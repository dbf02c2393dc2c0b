#pragma once

#include <bit>
#include <cstdint>

namespace foam::texgen {

/// Calls visit(begin, count) for the runs of bits that are set; not all are.
template <class Visit>
void for_each_run_of_bits(std::uint64_t bits, const Visit& visit) {
    while (bits != 0) {
        const int begin = std::countr_zero(bits);
        const int count = std::countr_one(bits >> begin);
        visit(begin, count);
        bits &= ~(((std::uint64_t{1} << count) - 1) << begin);
    }
}

}  // namespace foam::texgen
