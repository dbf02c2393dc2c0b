#pragma once

#include "texgen/raster/side_search.h"

#include <vector>

namespace foam::texgen {

/// What the pixels of a region, as a bubble or what is around a patch, are measured from. Keeps its
/// working memory from one region to the next.
class RegionField {
  public:
    enum class Kind {
        Bubble,
        Circle,  // a bubble whose boundary is a whole circle, in arcs
        Around,  // without smooth distances of its own
    };

    /// The boundaries, each with the region on its left, moved by `translation` (pixels).
    void place(const ArcLoops& boundaries, const Vec2& translation, Kind kind);

    /// As SideSearch does.
    template <class Visit>
    void for_each_tile(const CellMask& mask, int first_row, const Visit& visit) {
        sides_.for_each_tile(mask, first_row, visit);
    }

    /// Measures the pixels of a tile that for_each_tile has found.
    static void measure(const RegionTile& at,
                        std::span<const SideSearch::Side> sides,
                        DistanceTile& tile);

    /// Adds smooth distances to a tile that was measured.
    void measure_smooth(const RegionTile& at, DistanceTile& tile) const;

  private:
    void place_films();

    Kind kind_ = Kind::Bubble;
    ArcLoops boundaries_;
    SideSearch sides_;
    std::vector<FieldArc> films_;
};

}  // namespace foam::texgen
