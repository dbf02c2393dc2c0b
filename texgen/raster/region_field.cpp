#include "texgen/raster/region_field.h"

#include <cmath>

namespace foam::texgen {

namespace {

// A film of a chord below this part of its distance adds less than 1e-8 to a smooth distance, and
// its functions might leave the range of floats.
constexpr double kLeastChord = 1e-4;

// A circle is cut off nowhere.
Pencil whole_circle_at(const FieldArc& arc, const Vec2& point) {
    constexpr double kEverywhere = 1e15;
    return {pencil_at(arc, point).across, {kEverywhere, Vec2::Zero(), 0.0}};
}

}  // namespace

void RegionField::place(const ArcLoops& boundaries, const Vec2& translation, Kind kind) {
    kind_ = kind;
    boundaries_ = boundaries;
    for (ArcLoops::Arc& side : boundaries_.arcs) {
        side.tail += translation;
    }
    sides_.clear();
    std::size_t begin = 0;
    for (const std::size_t end : boundaries_.loop_ends) {
        sides_.add_loop(std::span(boundaries_.arcs).subspan(begin, end - begin));
        begin = end;
    }
    place_films();
}

void RegionField::place_films() {
    films_.clear();
    if (kind_ == Kind::Around) {
        return;
    }
    for (const ArcLoops::Arc& side : boundaries_.arcs) {
        if (side.arc.chord.norm() > 0.0 && (kind_ != Kind::Circle || films_.empty())) {
            films_.push_back(field_arc(side.arc, side.tail));
        }
    }
}

void RegionField::measure(const RegionTile& at,
                          std::span<const SideSearch::Side> sides,
                          DistanceTile& tile) {
    tile.reset(at.rows);
    for (const SideSearch::Side& side : sides) {
        tile.add_arc(pencil_at(side.arc, at.middle).across, end_normals_at(side.arc, at.middle));
        if (side.corner) {
            tile.add_point(side.tail - at.middle);
        }
    }
    if (!tile.is_unresolved()) {
        return;
    }
    for (const SideSearch::Side& side : sides) {  // a pixel a little out of a sharp corner
        tile.add_point(side.tail - at.middle);
        tile.add_point(side.head - at.middle);
    }
}

void RegionField::measure_smooth(const RegionTile& at, DistanceTile& tile) const {
    for (const FieldArc& film : films_) {
        const double far = (at.middle - film.middle).norm() + DistanceTile::kReach;
        if (film.chord > kLeastChord * far) {
            tile.add_film(kind_ == Kind::Circle ? whole_circle_at(film, at.middle)
                                                : pencil_at(film, at.middle),
                          film.chord);
        }
    }
    tile.finish_smooth();
}

}  // namespace foam::texgen
