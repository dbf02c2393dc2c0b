// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/frame_mesh.h"

#include "texgen/maps/relief.h"
#include "texgen/mesh/extrusion.h"
#include "texgen/mesh/height_slab.h"
#include "texgen/vector/appearance.h"
#include "texgen/vector/flattened.h"
#include "texgen/vector/foam_layout.h"
#include "texgen/vector/tile_cut.h"
#include "texgen/vector/wall_outlines.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

double millions(std::size_t count) {
    return static_cast<double>(count) * 1e-6;
}

// Returns the content whose lines are the walls of a mesh. The solution of a maze is not a wall:
// a mesh of the content MazeSolution shows the content Maze.
VectorContent wall_content(const VectorSettings& settings) {
    const VectorContent content = shown_content(settings.drawing, settings.map_names);
    return content == VectorContent::MazeSolution ? VectorContent::Maze : content;
}

// The positions of the columns or the rows of a slab, in millimeters, and the columns or rows of
// the image that they show.
struct Samples {
    std::vector<float> positions;
    std::vector<int> pixels;
};

Samples samples_along(int count, double pixel, bool repeats) {
    Samples samples;
    if (repeats) {
        for (int k = 0; k <= count; ++k) {
            samples.positions.push_back(static_cast<float>(k * pixel));
            samples.pixels.push_back(k % count);
        }
        return samples;
    }
    for (int k = 0; k <= count + 1; ++k) {
        const double center = std::clamp(k - 0.5, 0.0, static_cast<double>(count));
        samples.positions.push_back(static_cast<float>(center * pixel));
        samples.pixels.push_back(std::clamp(k - 1, 0, count - 1));
    }
    return samples;
}

// Returns the height of row 0 at `x` pixels to the right of the center of its first pixel. The row
// repeats on both sides. Heights between the centers of pixels are interpolated.
double height_between(const Image<float>& heights, double x) {
    const double left = std::floor(x);
    const auto height_of_column = [&](double column) {
        const double wrapped = column - std::floor(column / heights.width()) * heights.width();
        return static_cast<double>(heights.samples()[static_cast<std::size_t>(wrapped)]);
    };
    return height_of_column(left) +
           (x - left) * (height_of_column(left + 1.0) - height_of_column(left));
}

// Returns the heights at the points of the slab, row by row. On a torus, the last row of the slab
// is the first row displaced to the right by `shear`. The heights and `shear` are in pixels.
std::vector<float> heights_at(const Samples& columns,
                              const Samples& rows,
                              const Image<float>& heights,
                              double shear) {
    std::vector<float> all;
    all.reserve(columns.pixels.size() * rows.pixels.size());
    for (const int row : rows.pixels) {
        const auto start =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(heights.width());
        for (const int column : columns.pixels) {
            all.push_back(heights.samples()[start + static_cast<std::size_t>(column)]);
        }
    }
    if (shear != 0.0) {
        const std::size_t last = all.size() - columns.pixels.size();
        for (std::size_t k = 0; k < columns.pixels.size(); ++k) {
            all[last + k] =
                static_cast<float>(height_between(heights, static_cast<double>(k) - shear));
        }
    }
    return all;
}

// Converts heights from pixels to millimeters above the bottom of the slab.
void raise(std::vector<float>& heights, double pixel, const MeshOptions& options) {
    const auto [low, high] = std::ranges::minmax_element(heights);
    const auto lowest = static_cast<double>(*low);
    const double range = static_cast<double>(*high) - lowest;
    const double scale = options.relief_mm > 0.0 && range > 0.0 ? options.relief_mm / range : pixel;
    for (float& height : heights) {
        height =
            static_cast<float>(options.base_mm + scale * (static_cast<double>(height) - lowest));
    }
}

Mesh relief_mesh(const VectorSource& source) {
    const MapOptions& maps = source.settings.maps;
    const RasterGrid& grid = source.layers.grid();
    const Domain& domain = source.layers.frame().domain;
    const Page page = page_of(domain, grid, source.settings.drawing.width_mm);
    const std::array<std::string, 1> needed{std::string(kHeightMap.name)};
    FrameLayers layers = source.layers.on_grid(grid, distance_needs(needed, maps));
    const Image<float> heights = Relief(layers, {maps.relief, maps.maze}, Relief::kFoot).heights();
    const Samples columns = samples_along(grid.width, page.pixel, !domain.is_plane());
    const Samples rows = samples_along(grid.height, page.pixel, !domain.is_plane());
    const double shear = domain.is_plane() ? 0.0 : page.domain.shear / page.pixel;
    HeightField field{columns.positions, rows.positions, heights_at(columns, rows, heights, shear)};
    raise(field.z, page.pixel, source.settings.mesh);
    return height_slab(field);
}

// Returns the outer outlines of walls. Outlines of holes, which are clockwise, are removed.
std::vector<Chain> outer_chains(std::vector<Chain> chains) {
    std::erase_if(chains, [](const Chain& chain) { return signed_area(chain) <= 0.0; });
    return chains;
}

void check_triangles(std::span<const Chain> chains, const MeshOptions& options) {
    std::size_t corners = 0;
    for (const Chain& chain : chains) {
        for (const DrawnArc& arc : arcs_of(chain)) {
            corners += part_count(arc, options.tolerance_mm);
        }
    }
    if (kTrianglesPerCorner * corners > kMaxTriangles) {
        throw std::invalid_argument(fmt::format(
            "mesh.tolerance_mm = {}: the walls have about {:.1f} million triangles, but at most "
            "{:.0f} million are allowed; choose a larger tolerance",
            options.tolerance_mm,
            millions(kTrianglesPerCorner * corners),
            millions(kMaxTriangles)));
    }
}

Mesh wall_mesh(const VectorSource& source) {
    const VectorSettings& settings = source.settings;
    const MeshOptions& options = settings.mesh;
    FrameLayers& layers = source.layers;
    const Frame& frame = layers.frame();
    const Page page = page_of(frame.domain, layers.grid(), settings.drawing.width_mm);
    const FoamLayout layout(frame, page, settings.drawing.wrap);
    const Appearance look = appearance_of(layers, wall_content(settings), settings.maps);
    const double width = drawn_width(look, page, settings.drawing);
    std::vector<Chain> walls = wall_outlines(layout.lines_near_tile(look.has_line, width), width);
    std::vector<Chain> plate;
    if (layout.is_cut()) {
        walls = clipped_to_tile(walls, page.width, page.height);
        plate = {tile_outline(page.width, page.height)};
    } else if (options.base_mm > 0.0) {
        const auto all_films = layout.lines([](FilmId) { return true; });
        plate = outer_chains(wall_outlines(all_films, 2.0 * width));
    }
    if (walls.empty()) {
        throw std::invalid_argument(fmt::format(
            "frame {} has no walls, so that a mesh of them would be empty", frame.number));
    }
    check_triangles(walls, options);
    return extruded({.walls = flattened(walls, options.tolerance_mm),
                     .plate = flattened(plate, options.tolerance_mm),
                     .reaches_border = layout.is_cut(),
                     .base_height = options.base_mm,
                     .wall_height = options.wall_mm});
}

void check_relief(const VectorSettings& settings) {
    if (settings.mesh.base_mm <= 0.0) {
        throw std::invalid_argument(
            "mesh.base_mm = 0: only walls can do without a base; a relief needs at least 0.01");
    }
    // A slab has one more column and row than the image. In a view of the plane it has two more, of
    // which the second is neglected here.
    const std::size_t triangles = slab_triangles(static_cast<std::size_t>(settings.width) + 1,
                                                 static_cast<std::size_t>(settings.height) + 1);
    if (triangles > kMaxTriangles) {
        throw std::invalid_argument(
            fmt::format("image.size = [{}, {}]: the relief has {:.1f} million triangles, but at "
                        "most {:.0f} million are allowed; choose a smaller size",
                        settings.width,
                        settings.height,
                        millions(triangles),
                        millions(kMaxTriangles)));
    }
}

}  // namespace

MeshKind shown_kind(const VectorSettings& settings) {
    if (settings.mesh.kind != MeshKind::Auto) {
        return settings.mesh.kind;
    }
    const bool is_foam = shown_content(settings.drawing, settings.map_names) == VectorContent::Foam;
    return is_foam ? MeshKind::Relief : MeshKind::Walls;
}

void check_mesh(const VectorSettings& settings) {
    if (shown_kind(settings) == MeshKind::Relief) {
        check_relief(settings);
        return;
    }
    check_wall_width(wall_content(settings), settings.maps, settings.drawing);
}

Mesh frame_mesh(const VectorSource& source) {
    check_mesh(source.settings);
    return shown_kind(source.settings) == MeshKind::Relief ? relief_mesh(source)
                                                           : wall_mesh(source);
}

}  // namespace foam::texgen
