#include "core/foam/seeding.h"

#include "core/foam/random.h"
#include "core/foam/voronoi.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace foam {

namespace {

// Two sites on one grid point, or four on one circle, are a chance of about 1e-8 a diagram.
constexpr int kMostDraws = 4;

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

Torus torus_for(const SeedingOptions& options) {
    const double height = std::sqrt(options.bubbles / options.aspect);
    return {options.aspect * height, height};
}

std::vector<Vec2> random_sites(const Torus& torus, int count, Random& random) {
    std::vector<Vec2> sites;
    for (int k = 0; k < count; ++k) {
        const double x = torus.width * random.uniform();
        const double y = torus.height * random.uniform();
        sites.emplace_back(x, y);
    }
    return sites;
}

CellDiagram lloyd_relaxed(const Torus& torus, std::vector<Vec2> sites, int iterations) {
    CellDiagram cells = voronoi_cells(torus, sites);
    for (int k = 0; k < iterations; ++k) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const Vec2 centre = cell_centroid(cells[cell]);
            sites[cell] = centre - torus.translation(torus.cell_of(centre));
        }
        cells = voronoi_cells(torus, sites);
    }
    return cells;
}

// Areas spread evenly in the logarithm over the ratio, given out in the order of the present ones.
void spread_targets(Indexed<BubbleId, double>& areas, double ratio) {
    std::vector<std::size_t> rank(areas.size());
    std::iota(rank.begin(), rank.end(), std::size_t{0});
    std::stable_sort(rank.begin(), rank.end(), [&](std::size_t a, std::size_t b) {
        return areas[id_at<BubbleId>(a)] < areas[id_at<BubbleId>(b)];
    });
    const double last = std::max<double>(1.0, static_cast<double>(rank.size()) - 1.0);
    for (std::size_t k = 0; k < rank.size(); ++k) {
        areas[id_at<BubbleId>(rank[k])] = std::pow(ratio, static_cast<double>(k) / last);
    }
}

void scale_to_total(Indexed<BubbleId, double>& areas, double total) {
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double& area : areas) {
        area *= total / sum;
    }
}

Foam draw_foam(const SeedingOptions& options, const Torus& torus, Random& random) {
    for (int draw = 1;; ++draw) {
        try {
            const std::vector<Vec2> sites = random_sites(torus, options.bubbles, random);
            return foam_from_cells(torus, lloyd_relaxed(torus, sites, options.lloyd_iterations));
        } catch (const std::runtime_error&) {
            if (draw == kMostDraws) {
                throw;
            }
        }
    }
}

}  // namespace

Foam seed_foam(const SeedingOptions& options) {
    check(options);
    Random random(options.seed);
    const Torus torus = torus_for(options);
    Foam foam = draw_foam(options, torus, random);
    foam.film_tension = 2.0 * options.surface_tension;
    if (options.area_ratio > 0.0) {
        spread_targets(foam.target_areas, options.area_ratio);
    }
    scale_to_total(foam.target_areas, torus.area());
    return foam;
}

}  // namespace foam
