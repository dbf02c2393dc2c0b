#include "texgen/raster/cell_place.h"

namespace foam::texgen {

void place_cell(const BubbleSides& sides,
                const CellPlace& at,
                RowCrossings& crossings,
                CellMask& mask,
                RegionField& region) {
    region.clear(RegionField::Kind::Bubble);
    const SubpixelPoint from_mask = at.translation - at.mask;
    Vec2 from = at.first_tail(sides);
    for (std::size_t k = 0; k < sides.count; ++k) {
        const PixelArc arc = sides.arc(k);
        if (arc.chord.norm() > kShortestSide) {
            region.add_side(field_arc(arc, from));
        }
        from += arc.chord;
        crossings.add({sides.tail(k) + from_mask,
                       sides.tail(k + 1 < sides.count ? k + 1 : 0) + from_mask,
                       arc.cosine,
                       arc.sine},
                      mask);
    }
    crossings.mark(mask);
    region.close_boundary();
}

}  // namespace foam::texgen
