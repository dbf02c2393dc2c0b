#include "texgen/raster/pixel_regions.h"

#include "texgen/raster/patch_boundaries.h"

namespace foam::texgen {

namespace {

constexpr double kShortestSide = 1e-9;  // pixels; a shorter side has no direction to speak of

}  // namespace

void PixelRegions::place(const Outline& outline,
                         SubpixelPoint translation,
                         SubpixelPoint corner,
                         RegionField& field) const {
    if (cells_.outside) {
        place_in_plane(outline.bubble, Vec2(corner.x, corner.y) / kSubpixel, field);
    } else {
        const SubpixelPoint first = cells_.chain(outline).front() + translation - corner;
        place_on_torus(outline.bubble, Vec2(first.x, first.y) / kSubpixel, field);
    }
}

void PixelRegions::place_ghost(RegionField& field) const {
    place_in_plane(*cells_.outside, Vec2::Zero(), field);
}

void PixelRegions::place_in_plane(BubbleId bubble, const Vec2& corner, RegionField& field) const {
    const bool is_circle = index_of(bubble) >= frame_.network.bubble_slots();
    field.clear(bubble == *cells_.outside ? RegionField::Kind::Around
                : is_circle               ? RegionField::Kind::Circle
                                          : RegionField::Kind::Bubble);
    const Boundaries boundaries = boundaries_of({frame_, cells_.grid, scale_}, bubble);
    std::size_t k = 0;
    for (const std::size_t end : boundaries.loop_ends) {
        for (; k < end; ++k) {
            const ArcLoops::Arc& side = boundaries.arcs[k];
            if (side.arc.chord.norm() > kShortestSide) {
                field.add_side(field_arc(side.arc, side.tail - corner));
            }
        }
        field.close_boundary();
    }
}

// The outline begins at `first`; that was rounded to a subpixel, which the arcs are not.
void PixelRegions::place_on_torus(BubbleId bubble, const Vec2& first, RegionField& field) const {
    field.clear(RegionField::Kind::Bubble);
    const Network& network = frame_.network;
    const HalfEdgeId begin = network.first(bubble);
    const Vec2& position = frame_.positions[network.tail(begin)];
    const SubpixelPoint snapped = snap(cells_.grid, frame_.torus, position);
    Vec2 tail = first + scale_ * position - Vec2(snapped.x, snapped.y) / kSubpixel;
    HalfEdgeId h = begin;
    do {
        const FilmArc arc = frame_.arc(h);
        const FieldArc side = field_arc({scale_ * arc.chord, arc.half_angle}, tail);
        if (side.chord > kShortestSide) {
            field.add_side(side);
        }
        tail += scale_ * arc.chord;
        h = network.next(h);
    } while (h != begin);
    field.close_boundary();
}

}  // namespace foam::texgen
