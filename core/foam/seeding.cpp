// SPDX-License-Identifier: Apache-2.0

#include "core/foam/seeding.h"

#include "core/foam/clipped_cells.h"
#include "core/foam/random.h"
#include "core/foam/spatial_order.h"
#include "core/foam/target_areas.h"
#include "core/foam/voronoi.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

// Seeds a foam on a torus from the Voronoi diagram of uniformly random sites (paper section 5;
// before it Weaire and Kermode, Philosophical Magazine B 50, 1984). Each iteration of Lloyd's
// algorithm moves every site to the centroid of its cell and takes the diagram of the new sites (S.
// P. Lloyd, Least squares quantization in PCM, IEEE Transactions on Information Theory 28, 1982).
// The iterations make the cells more regular. An area field gives the relative area that bubbles
// should have at each point. If there is one, the centroids are weighted (area_field.h), and the
// density of the random sites is proportional to 1 / area.

namespace foam {

namespace {

// A draw is one attempt to make a foam from new random sites. It fails if two sites share a grid
// point (voronoi.h) or if four sites are on one circle. For 10,000 sites, the probability of this
// is about 1e-8 per diagram. A draw also fails if a long torus has too few sites (voronoi.h).
constexpr int kMaxSeedDraws = 4;

void check(const SeedingOptions& options) {
    if (options.bubbles < 1) {
        throw std::invalid_argument("a foam needs at least one bubble");
    }
    if (!(options.aspect > 0.0) || !(options.surface_tension > 0.0)) {
        throw std::invalid_argument("aspect and surface tension must be positive");
    }
    if (options.area_ratio != 0.0 && !(options.area_ratio >= 1.0)) {
        throw std::invalid_argument("the area ratio must be 0 or at least 1");
    }
}

Domain torus_for(const SeedingOptions& options) {
    const double height = std::sqrt(options.bubbles / options.aspect);
    return {options.aspect * height, height};
}

std::vector<Vec2> random_sites(const Domain& domain,
                               const SeedingOptions& options,
                               Random& random) {
    std::vector<Vec2> sites;
    for (int k = 0; k < options.bubbles; ++k) {
        if (options.areas) {
            sites.push_back(options.areas->random_point(random));
            continue;
        }
        const double x = domain.width * random.uniform();
        const double y = domain.height * random.uniform();
        sites.emplace_back(x, y);
    }
    return sites;
}

CellDiagram lloyd_relaxed(const Domain& domain,
                          const SeedingOptions& options,
                          std::vector<Vec2> sites) {
    const AreaField* const areas = options.areas ? &*options.areas : nullptr;
    CellDiagram cells = voronoi_cells(domain, sites);
    for (int k = 0; k < options.lloyd_iterations; ++k) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const Vec2 center = lloyd_center(cell_polygon(cells[cell]), areas);
            sites[cell] = center - domain.translation(domain.cell_of(center));
        }
        cells = voronoi_cells(domain, sites);
    }
    return cells;
}

// Sets the target areas that the options ask for. Precondition: the target areas of the foam are
// the areas of the cells.
void set_targets(const SeedingOptions& options, const CellDiagram& cells, Foam& foam) {
    std::vector<double> field;
    for (std::size_t cell = 0; options.areas && cell < cells.size(); ++cell) {
        field.push_back(options.areas->mean_over(cell_polygon(cells[cell])));
    }
    const std::span<double> targets(foam.target_areas.begin(), foam.target_areas.end());
    set_target_areas(targets, field, options.area_ratio);
    scale_to_total(targets, foam.domain.area());
}

Foam draw_foam(const SeedingOptions& options, const Domain& domain, Random& random) {
    for (int draw = 1;; ++draw) {
        try {
            const CellDiagram cells =
                lloyd_relaxed(domain, options, random_sites(domain, options, random));
            Foam foam = foam_from_cells(domain, cells);
            set_targets(options, cells, foam);
            return foam;
        } catch (const std::runtime_error&) {
            if (draw == kMaxSeedDraws) {
                throw;
            }
        }
    }
}

}  // namespace

Foam seed_foam(const SeedingOptions& options) {
    check(options);
    Random random(options.seed);
    const Domain domain = torus_for(options);
    SeedingOptions stretched = options;
    if (options.areas) {
        stretched.areas = options.areas->stretched_over({0.0, 0.0}, {domain.width, domain.height});
    }
    Foam foam = draw_foam(stretched, domain, random);
    foam.film_tension = 2.0 * options.surface_tension;
    sort_if_large(foam);
    return foam;
}

}  // namespace foam
