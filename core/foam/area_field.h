// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/random.h"
#include "core/geometry/vec2.h"

#include <memory>
#include <span>
#include <vector>

namespace foam {

/// The relative areas that bubbles should have at every point of a rectangle. The rectangle is
/// divided into a grid of equal cells, and the area is constant within a cell. The number of
/// bubbles per unit area is proportional to 1 / area. Copies of an AreaField share one grid.
class AreaField {
  public:
    /// Creates a field on the rectangle from (0, 0) to (1, 1). `areas` has one positive number per
    /// cell, in rows from bottom to top. Throws std::invalid_argument if the numbers of columns,
    /// rows and areas do not fit together, or if an area is not positive and finite.
    AreaField(int columns, int rows, std::vector<double> areas);

    /// Returns this field, stretched over the rectangle with the lower left corner `low` and the
    /// width and height `size`.
    AreaField stretched_over(const Vec2& low, const Vec2& size) const;

    /// Returns the area at a point. Outside of the rectangle, the field is repeated periodically.
    double at(const Vec2& point) const;

    /// Returns a random point of the rectangle; its probability density is proportional to
    /// 1 / area. Uses three random numbers.
    Vec2 random_point(Random& random) const;

    /// Returns the area that a bubble covering a polygon should have: the harmonic mean of the
    /// field over the polygon. The distance between sample points is at most about the shorter side
    /// of a cell of the grid or, in a large polygon, about 1/32 of the size of the polygon
    /// (visit_polygon_samples). Precondition: the polygon is counter-clockwise.
    double mean_over(std::span<const Vec2> polygon) const;

    /// Returns the point to which Lloyd's algorithm moves the site of a Voronoi cell. The polygon
    /// is the cell, and the point is its centroid for the weight 1 / area^2. In the plane, the
    /// density of sites tends to the square root of the weight (Q. Du, V. Faber, M. Gunzburger,
    /// "Centroidal Voronoi tessellations", SIAM Review 41, 1999). With this weight, the algorithm
    /// therefore makes the number of sites per unit area proportional to 1 / area. Precondition:
    /// the polygon is counter-clockwise.
    Vec2 centroid_of(std::span<const Vec2> polygon) const;

  private:
    struct Grid {
        int columns = 0;
        int rows = 0;
        std::vector<double> areas;
        std::vector<double> sums;  // sums[k] is the sum of 1 / area over the cells 0 to k
    };

    double cell_size() const;  // the shorter side of a cell

    std::shared_ptr<const Grid> grid_;
    Vec2 low_{0.0, 0.0};
    Vec2 size_{1.0, 1.0};
};

}  // namespace foam
