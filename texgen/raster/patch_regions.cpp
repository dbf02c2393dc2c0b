#include "texgen/raster/patch_regions.h"

#include "texgen/raster/arcs/patch_boundaries.h"

namespace foam::texgen {

void PatchRegions::place(BubbleId bubble, SubpixelPoint corner, RegionField& field) const {
    const bool is_circle = index_of(bubble) >= frame_.network.bubble_slots();
    field.clear(bubble == frame_.network.ghost() ? RegionField::Kind::Around
                : is_circle                      ? RegionField::Kind::Circle
                                                 : RegionField::Kind::Bubble);
    const Vec2 origin = Vec2(corner.x, corner.y) / kSubpixel;
    const Boundaries boundaries = boundaries_of({frame_, grid_, scale_}, bubble);
    std::size_t k = 0;
    for (const std::size_t end : boundaries.loop_ends) {
        for (; k < end; ++k) {
            const ArcLoops::Arc& side = boundaries.arcs[k];
            if (side.arc.chord.norm() > kShortestSide) {
                field.add_side(field_arc(side.arc, side.tail - origin));
            }
        }
        field.close_boundary();
    }
}

}  // namespace foam::texgen
