#include "texgen/raster/rising_arc.h"

#include "texgen/raster/vector_clones.h"

namespace foam::texgen {

namespace {

// crossing(arc, at) of all; inlined, or the copies for other processors would share this one.
template <class Crossing>
[[gnu::always_inline]] inline void find(std::span<const ArcCrossings> arcs,
                                        const Crossing& crossing,
                                        std::int32_t* to) {
    for (const ArcCrossings& crossings : arcs) {
        const RisingArc arc = crossings.arc;
        const double step = crossings.step;
        const std::int32_t offset = crossings.offset;
        const std::int32_t sign = crossings.sign;
        for (std::size_t from = 0; from < crossings.count; from += ArcCrossings::kLanes) {
            const double first = crossings.first + static_cast<double>(from) * step;
            std::int32_t* found = to + crossings.place + from;
            for (std::size_t k = 0; k < ArcCrossings::kLanes; ++k) {
                const double at = first + static_cast<double>(k) * step;
                found[k] = sign * (offset + rounded(crossing(arc, at)));
            }
        }
    }
}

}  // namespace

FOAMTEX_VECTOR_CLONES void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs) {
    find(
        arcs, [](const RisingArc& arc, double y) { return arc.x_at(y); }, xs);
}

FOAMTEX_VECTOR_CLONES void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys) {
    find(
        arcs, [](const RisingArc& arc, double x) { return arc.y_at(x); }, ys);
}

}  // namespace foam::texgen
