// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/arc_crossings.h"

#include "texgen/raster/simd/kernel.h"

namespace foam::texgen {

namespace {

// Computes the crossings that a query asks for. crossing(arc, at) returns the crossing of the arc
// with the line at the coordinate `at`. Coordinates are of type Real.
template <class Real, class Crossing>
inline void find_of(const CrossingSolver<Real> arc,
                    const CrossingQuery& query,
                    const Crossing& crossing,
                    std::int32_t* __restrict to) {
    for (std::size_t from = 0; from < query.count; from += CrossingQuery::kLanes) {
        const std::int32_t first = query.first + static_cast<std::int32_t>(from) * query.step;
        for (std::size_t k = 0; k < CrossingQuery::kLanes; ++k) {
            const std::int32_t at = first + static_cast<std::int32_t>(k) * query.step;
            to[query.position + from + k] =
                query.sign * (query.offset + rounded(crossing(arc, static_cast<Real>(at))));
        }
    }
}

// Computes the crossings for all queries, in floats for short arcs and in doubles for long arcs.
template <class Crossing>
void find(std::span<const CrossingQuery> queries, const Crossing& crossing, std::int32_t* to) {
    at_simd_level([=] {
        for (const CrossingQuery& query : queries) {
            if (query.arc.is_short()) [[likely]] {
                find_of(query.arc.in_floats(), query, crossing, to);
            } else {
                find_of(query.arc.in_doubles(), query, crossing, to);
            }
        }
    });
}

}  // namespace

void find_xs(std::span<const CrossingQuery> queries, std::int32_t* xs) {
    find(
        queries, [](const auto& arc, auto y) { return arc.x_at(y); }, xs);
}

void find_ys(std::span<const CrossingQuery> queries, std::int32_t* ys) {
    find(
        queries, [](const auto& arc, auto x) { return arc.y_at(x); }, ys);
}

}  // namespace foam::texgen
