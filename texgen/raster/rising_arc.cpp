#include "texgen/raster/rising_arc.h"

#include "texgen/raster/vector_clones.h"

namespace foam::texgen {

FOAMTEX_VECTOR_CLONES void RisingArc::find_x(double y,
                                             double step,
                                             std::span<std::int32_t> xs) const {
    const RisingArc arc = *this;
    std::int32_t* to = xs.data();
    const auto count = static_cast<std::int32_t>(xs.size());
    for (std::int32_t k = 0; k < count; ++k) {
        to[k] = rounded(arc.x_at(y + k * step));
    }
}

FOAMTEX_VECTOR_CLONES void RisingArc::find_y(double x,
                                             double step,
                                             std::span<std::int32_t> ys) const {
    const RisingArc arc = *this;
    std::int32_t* to = ys.data();
    const auto count = static_cast<std::int32_t>(ys.size());
    for (std::int32_t k = 0; k < count; ++k) {
        to[k] = rounded(arc.y_at(x + k * step));
    }
}

}  // namespace foam::texgen
