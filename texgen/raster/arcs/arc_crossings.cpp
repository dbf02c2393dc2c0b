// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/arc_crossings.h"

#include "texgen/raster/simd/kernel.h"

namespace foam::texgen {

namespace {

// Computes the results of a query. crossing(arc, at) must return the crossing of the arc with the
// line at `at`.
template <class Real, class Crossing>
inline void find_of(const CrossingSolver<Real>& equation,
                    const ArcCrossings& crossings,
                    const Crossing& crossing,
                    std::int32_t* to) {
    const CrossingSolver<Real> arc = equation;  // a copy, which the stores below cannot change
    const std::int32_t step = crossings.step;
    const std::int32_t offset = crossings.offset;
    const std::int32_t sign = crossings.sign;
    for (std::size_t from = 0; from < crossings.count; from += ArcCrossings::kLanes) {
        const std::int32_t first = crossings.first + static_cast<std::int32_t>(from) * step;
        std::int32_t* found = to + from;
        for (std::size_t k = 0; k < ArcCrossings::kLanes; ++k) {
            const std::int32_t at = first + static_cast<std::int32_t>(k) * step;
            found[k] = sign * (offset + rounded(crossing(arc, static_cast<Real>(at))));
        }
    }
}

// Computes the results of all queries, in floats for short arcs and in doubles for long arcs.
template <class Crossing>
void find(std::span<const ArcCrossings> arcs, const Crossing& crossing, std::int32_t* to) {
    at_simd_level([=] {
        for (const ArcCrossings& crossings : arcs) {
            if (crossings.arc.is_short()) [[likely]] {
                find_of(crossings.arc.in_floats(), crossings, crossing, to + crossings.position);
            } else {
                find_of(crossings.arc.in_doubles(), crossings, crossing, to + crossings.position);
            }
        }
    });
}

}  // namespace

void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs) {
    find(
        arcs, [](const auto& arc, auto y) { return arc.x_at(y); }, xs);
}

void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys) {
    find(
        arcs, [](const auto& arc, auto x) { return arc.y_at(x); }, ys);
}

}  // namespace foam::texgen
