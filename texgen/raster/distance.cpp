#include "texgen/raster/distance.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/patch_field.h"
#include "texgen/raster/torus_field.h"

namespace foam::texgen {

namespace {

template <class Sample>
void ask_for(bool needed, const RasterGrid& grid, int channels, Image<Sample>& image) {
    const bool fits = image.width() == grid.width && image.height() == grid.height;
    if (!needed) {
        image = {};
    } else if (!fits) {
        image = Image<Sample>(grid.width, grid.height, channels);
    }
}

void ask_for(DistanceNeeds needs, const RasterGrid& grid, DistanceField& field) {
    ask_for(true, grid, 1, field.ids);
    ask_for(true, grid, 1, field.distance);
    ask_for(needs.gradient, grid, 2, field.gradient);
    ask_for(needs.smooth, grid, 1, field.smooth);
    ask_for(needs.smooth, grid, 2, field.smooth_gradient);
}

}  // namespace

void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    pixels_per_unit(grid, frame.domain);  // throws before anything is changed
    ask_for(needs, grid, field);
    if (frame.domain.is_plane()) {
        write_patch_field(frame, grid, needs, threads, field);
    } else {
        write_torus_field(frame, grid, needs, threads, field);
    }
}

DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads) {
    DistanceField field;
    write_distance_field(frame, grid, needs, threads, field);
    return field;
}

}  // namespace foam::texgen
