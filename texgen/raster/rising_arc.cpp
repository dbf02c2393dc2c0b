#include "texgen/raster/rising_arc.h"

#include "texgen/raster/vector_clones.h"

namespace foam::texgen {

FOAMTEX_VECTOR_CLONES void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs) {
    constexpr std::size_t kLanes = ArcCrossings::kLanes;
    for (const ArcCrossings& crossings : arcs) {
        const RisingArc arc = crossings.arc;
        const double step = crossings.step;
        for (std::size_t from = 0; from < crossings.count; from += kLanes) {
            const double y = crossings.first + static_cast<double>(from) * step;
            std::int32_t* to = xs + crossings.place + from;
            for (std::size_t k = 0; k < kLanes; ++k) {
                to[k] = rounded(arc.x_at(y + static_cast<double>(k) * step));
            }
        }
    }
}

FOAMTEX_VECTOR_CLONES void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys) {
    constexpr std::size_t kLanes = ArcCrossings::kLanes;
    for (const ArcCrossings& crossings : arcs) {
        const RisingArc arc = crossings.arc;
        const double step = crossings.step;
        for (std::size_t from = 0; from < crossings.count; from += kLanes) {
            const double x = crossings.first + static_cast<double>(from) * step;
            std::int32_t* to = ys + crossings.place + from;
            for (std::size_t k = 0; k < kLanes; ++k) {
                to[k] = rounded(arc.y_at(x + static_cast<double>(k) * step));
            }
        }
    }
}

}  // namespace foam::texgen
