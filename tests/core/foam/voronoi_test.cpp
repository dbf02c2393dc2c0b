// SPDX-License-Identifier: Apache-2.0

#include "core/foam/voronoi.h"

#include "core/foam/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam {
namespace {

// Sites are rounded to a grid with a spacing of 2^-26 = 1.5e-8 of the longer side. A corner between
// sites that are nearly on a line moves by several hundred times this spacing.
constexpr double kGrid = 0x1.0p-26;
constexpr double kTolerance = 1000.0 * kGrid;

std::vector<Vec2> random_sites(const Domain& domain, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec2> sites;
    for (int k = 0; k < count; ++k) {
        const double x = domain.width * random.uniform();
        const double y = domain.height * random.uniform();
        sites.emplace_back(x, y);
    }
    return sites;
}

// Returns the smallest distance of a point from the lattice copies of a site.
double distance_to_site(const Domain& domain, const Vec2& site, const Vec2& point) {
    const Vec2 apart = site - point;
    const Vec2 nearest = apart - Vec2(std::round(apart.x() / domain.width) * domain.width,
                                      std::round(apart.y() / domain.height) * domain.height);
    return nearest.norm();
}

double distance_to_nearest(const Domain& domain,
                           const std::vector<Vec2>& sites,
                           const Vec2& point) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const Vec2& site : sites) {
        minimum = std::min(minimum, distance_to_site(domain, site, point));
    }
    return minimum;
}

// Returns the smallest distance of a point from the lines of the sides of a convex cell, positive
// inside the cell.
double depth_in(const std::vector<CellCorner>& cell, const Vec2& point) {
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < cell.size(); ++k) {
        const Vec2& a = cell[k].point;
        const Vec2 along = (cell[(k + 1) % cell.size()].point - a).normalized();
        minimum = std::min(minimum, cross(along, point - a));
    }
    return minimum;
}

// Returns the lattice copy of a point that is nearest to a site.
Vec2 copy_near(const Domain& domain, const Vec2& point, const Vec2& site) {
    const Vec2 apart = point - site;
    return point - Vec2(std::round(apart.x() / domain.width) * domain.width,
                        std::round(apart.y() / domain.height) * domain.height);
}

struct Case {
    Domain domain;
    int sites;
    std::uint64_t seed;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const int sites : {2, 3, 5, 20, 100}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            all.push_back({{1.0, 1.0}, sites, seed});
            all.push_back({{6.0, 1.5}, sites, seed});
        }
    }
    return all;
}

// Expects that a corner is a corner of a Voronoi diagram. The distance to the cell's own site must
// be the same as to the sites across the two sides that meet at the corner, `before` and `corner`,
// and no other site may be nearer.
void expect_empty_circumcenter(const Domain& domain,
                               const std::vector<Vec2>& sites,
                               const Vec2& own_site,
                               const CellCorner& before,
                               const CellCorner& corner) {
    const double tolerance = kTolerance * std::max(domain.width, domain.height);
    const double radius = (corner.point - own_site).norm();
    for (const CellCorner& side : {before, corner}) {
        const Vec2 across = sites[side.across] + domain.translation(side.offset);
        EXPECT_NEAR((corner.point - across).norm(), radius, tolerance);
    }
    EXPECT_NEAR(distance_to_nearest(domain, sites, corner.point), radius, tolerance);
}

TEST(Voronoi, CornersAreEmptyCircumcenters) {
    for (const Case& c : cases()) {
        const std::vector<Vec2> sites = random_sites(c.domain, c.sites, c.seed);
        const CellDiagram cells = voronoi_cells(c.domain, sites);
        for (std::size_t k = 0; k < cells.size(); ++k) {
            CellCorner before = cells[k].back();
            for (const CellCorner& corner : cells[k]) {
                expect_empty_circumcenter(c.domain, sites, sites[k], before, corner);
                before = corner;
            }
        }
    }
}

// Each of some random points is in the cell of its nearest site, up to rounding.
TEST(Voronoi, PointsLieInTheCellOfTheirNearestSite) {
    for (const Case& c : cases()) {
        const std::vector<Vec2> sites = random_sites(c.domain, c.sites, c.seed);
        const CellDiagram cells = voronoi_cells(c.domain, sites);
        const double tolerance = kTolerance * std::max(c.domain.width, c.domain.height);
        for (const Vec2& point : random_sites(c.domain, 100, 1000 + c.seed)) {
            const auto nearer = [&](const Vec2& a, const Vec2& b) {
                return distance_to_site(c.domain, a, point) < distance_to_site(c.domain, b, point);
            };
            const auto nearest = static_cast<std::size_t>(
                std::min_element(sites.begin(), sites.end(), nearer) - sites.begin());
            const Vec2 copy = copy_near(c.domain, point, sites[nearest]);
            EXPECT_GT(depth_in(cells[nearest], copy), -tolerance);
        }
    }
}

TEST(Voronoi, CellsAreConvexAndFillTheTorus) {
    for (const Case& c : cases()) {
        const CellDiagram cells = voronoi_cells(c.domain, random_sites(c.domain, c.sites, c.seed));
        double total = 0.0;
        for (const std::vector<CellCorner>& cell : cells) {
            EXPECT_GT(depth_in(cell, polygon_centroid(cell_polygon(cell))), 0.0);
            total += cell_area(cell);
        }
        // The areas add up exactly, except for the rounding of the torus' sides to the grid.
        EXPECT_NEAR(total / c.domain.area(), 1.0, 8.0 * kGrid);
    }
}

std::string message_for(const Domain& domain, const std::vector<Vec2>& sites) {
    try {
        voronoi_cells(domain, sites);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Voronoi, RejectsCoincidentSites) {
    const Domain domain{3.0, 3.0};
    const std::string message =
        "two random sites are at the same point of the grid; try another seed";
    EXPECT_EQ(message_for(domain, {{0.1, 0.2}, {1.5, 1.1}, {1.5, 1.1}, {2.2, 0.7}, {0.9, 2.5}}),
              message);
    // Two sites are nearer to each other than half a grid spacing, which is 2.2e-8.
    EXPECT_EQ(message_for(domain, {{0.1, 0.2}, {1.5, 1.1}, {1.5, 1.1 + 1e-9}, {2.2, 0.7}}),
              message);
}

// The cells of four sites in a square grid are squares, whose corners join four cells.
TEST(Voronoi, FourSitesOnACircleMakeNoFoam) {
    const Domain domain{2.0, 2.0};
    const CellDiagram cells =
        voronoi_cells(domain, {{0.5, 0.5}, {1.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}});
    EXPECT_THROW(foam_from_cells(domain, cells), std::runtime_error);
}

// Copies of the sites are searched within 15 periods. On a torus a hundred times as wide as high,
// some neighbors are farther away.
TEST(Voronoi, RejectsATorusThatIsTooSlender) {
    const Domain domain{100.0, 1.0};
    EXPECT_EQ(message_for(domain, {{20.0, 0.5}, {70.0, 0.3}}),
              "the torus (100 x 1) is too long for 2 bubbles; use more bubbles or an aspect nearer "
              "to 1");
}

}  // namespace
}  // namespace foam
