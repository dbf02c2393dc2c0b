// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/contours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

// The region is where the numbers of the grid are at least the level. The grid has a border of
// zeros, so that each contour is a closed ring. Four neighboring points of the grid are the corners
// of a square. A contour crosses a side of a square where one end of the side is inside of the
// region and the other end is outside. Each square links its crossings in pairs. A
// counter-clockwise traversal of the square leaves the region at the start of a link, and enters it
// at the end of the link. The links form the rings.

namespace foam::texgen {

namespace {

using SideId = std::uint32_t;

constexpr SideId kNoSide = std::numeric_limits<SideId>::max();
constexpr std::size_t kCorners = 4;
// The smallest distance of a crossing from the points of the grid, as a fraction of a side. Rings
// therefore do not touch each other where a number equals the level.
constexpr double kMinDistance = 0.01;

class ContourTracer {
  public:
    ContourTracer(const Image<float>& grid, double level)
        : grid_(grid),
          level_(level),
          columns_(static_cast<SideId>(grid.width()) + 2),
          next_(static_cast<std::size_t>(2 * columns_) *
                    (static_cast<std::size_t>(grid.height()) + 2),
                kNoSide) {}

    std::vector<std::vector<Vec2>> trace() {
        for (int y = -1; y < grid_.height(); ++y) {
            for (int x = -1; x < grid_.width(); ++x) {
                link_square(x, y);
            }
        }
        std::vector<std::vector<Vec2>> rings;
        for (SideId side = 0; side < next_.size(); ++side) {
            if (next_[side] != kNoSide) {
                rings.push_back(take_ring(side));
            }
        }
        return rings;
    }

  private:
    double number(int x, int y) const {
        const bool is_inside = x >= 0 && y >= 0 && x < grid_.width() && y < grid_.height();
        return is_inside ? static_cast<double>(grid_.pixel(x, y)[0]) : 0.0;
    }

    // side_right returns the side from a point to its right neighbor, side_above the side to its
    // upper neighbor.
    SideId side_right(int x, int y) const {
        return 2 * (static_cast<SideId>(y + 1) * columns_ + static_cast<SideId>(x + 1));
    }
    SideId side_above(int x, int y) const { return side_right(x, y) + 1; }

    // Links the crossings of the square whose lower left corner is (x, y). If two opposite corners
    // are inside, the mean of the four numbers decides whether they are connected.
    void link_square(int x, int y) {
        const std::array<double, kCorners> corners = {
            number(x, y), number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)};
        const auto is_inside = [&](std::size_t k) { return corners[k % kCorners] >= level_; };
        const bool is_connected =
            0.25 * (corners[0] + corners[1] + corners[2] + corners[3]) >= level_;
        const std::array<SideId, kCorners> sides = {
            side_right(x, y), side_above(x + 1, y), side_right(x, y + 1), side_above(x, y)};
        for (std::size_t k = 0; k < kCorners; ++k) {
            if (!is_inside(k) || is_inside(k + 1)) {
                continue;
            }
            // The next side where the traversal enters, or the previous one if opposite corners are
            // not connected.
            std::size_t entry = k;
            do {
                entry = (entry + (is_connected ? 1 : kCorners - 1)) % kCorners;
            } while (is_inside(entry) || !is_inside(entry + 1));
            next_[sides[k]] = sides[entry];
        }
    }

    Vec2 crossing(SideId side) const {
        const SideId point = side / 2;
        const int x = static_cast<int>(point % columns_) - 1;
        const int y = static_cast<int>(point / columns_) - 1;
        const bool is_horizontal = side % 2 == 0;
        const double first = number(x, y);
        const double second = is_horizontal ? number(x + 1, y) : number(x, y + 1);
        const double t =
            std::clamp((level_ - first) / (second - first), kMinDistance, 1.0 - kMinDistance);
        return is_horizontal ? Vec2(x + t, y) : Vec2(x, y + t);
    }

    // Returns the ring that crosses the side `start`, and removes the links of the ring.
    std::vector<Vec2> take_ring(SideId start) {
        std::vector<Vec2> ring;
        for (SideId side = start; next_[side] != kNoSide;) {
            ring.push_back(crossing(side));
            const SideId next_side = next_[side];
            next_[side] = kNoSide;
            side = next_side;
        }
        return ring;
    }

    const Image<float>& grid_;
    double level_;
    SideId columns_;            // number of points in a row, with the border
    std::vector<SideId> next_;  // per side: the next crossing of the ring, or kNoSide
};

}  // namespace

std::vector<std::vector<Vec2>> contours(const Image<float>& grid, double level) {
    return ContourTracer(grid, level).trace();
}

}  // namespace foam::texgen
