// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace foam::texgen {

namespace {

// Positions along the border that differ by less than this fraction of its length may be in the
// wrong order because of rounding errors.
constexpr double kBorderTolerance = 1e-12;

// The border of a tile. A position along the border is the distance from the lower left corner,
// counter-clockwise.
class Border {
  public:
    Border(double width, double height) : width_(width), height_(height) {}

    double length() const { return 2.0 * (width_ + height_); }

    // Returns the position of the point of the border that is nearest to `point`.
    double position_of(const Vec2& point) const {
        const double bottom = std::abs(point.y());
        const double right = std::abs(point.x() - width_);
        const double top = std::abs(point.y() - height_);
        const double left = std::abs(point.x());
        const double nearest = std::min({bottom, right, top, left});
        if (nearest == bottom) {
            return point.x();
        }
        if (nearest == right) {
            return width_ + point.y();
        }
        return nearest == top ? width_ + height_ + (width_ - point.x())
                              : 2.0 * width_ + height_ + (height_ - point.y());
    }

    // Adds the corners between two positions, counter-clockwise, to the end of a chain.
    void add_corners(double from, double to, Chain& chain) const {
        const std::array<std::pair<double, Vec2>, 4> corners = {
            {{0.0, {0.0, 0.0}},
             {width_, {width_, 0.0}},
             {width_ + height_, {width_, height_}},
             {2.0 * width_ + height_, {0.0, height_}}}};
        const bool wraps = to < from - kBorderTolerance * length();
        const double end = wraps ? to + length() : to;
        for (const double turn : {0.0, length()}) {
            for (const auto& [position, corner] : corners) {
                if (position + turn > from && position + turn < end) {
                    add_line(corner, chain);
                }
            }
        }
    }

    static void add_line(const Vec2& point, Chain& chain) {
        if (point != chain.head()) {
            chain.steps.push_back({point, 0.0});
        }
    }

  private:
    double width_;
    double height_;
};

// An end of an open chain on the border.
struct BorderEnd {
    double position = 0.0;
    std::size_t chain = 0;
    bool enters = false;  // true for the tail of the chain
};

// Returns the tails and heads of all chains in the order of their positions. If rounding errors put
// two neighbors at almost the same position in the wrong order, they are exchanged. Tails and heads
// therefore alternate, unless the chains cross each other.
std::vector<BorderEnd> sorted_ends(const std::vector<Chain>& chains, const Border& border) {
    std::vector<BorderEnd> ends;
    for (std::size_t k = 0; k < chains.size(); ++k) {
        ends.push_back({border.position_of(chains[k].tail), k, true});
        ends.push_back({border.position_of(chains[k].head()), k, false});
    }
    std::ranges::stable_sort(ends, {}, &BorderEnd::position);
    for (std::size_t k = 1; k + 1 < ends.size(); ++k) {
        if (ends[k].enters == ends[k - 1].enters && ends[k + 1].enters != ends[k].enters &&
            ends[k + 1].position - ends[k].position < kBorderTolerance * border.length()) {
            std::swap(ends[k], ends[k + 1]);
        }
    }
    return ends;
}

// Returns, for each chain, the tail of the chain that follows it along the border.
std::vector<BorderEnd> followers(const std::vector<Chain>& chains, const Border& border) {
    const std::vector<BorderEnd> ends = sorted_ends(chains, border);
    std::vector<BorderEnd> following(chains.size());
    for (std::size_t k = 0; k < ends.size(); ++k) {
        if (!ends[k].enters) {
            std::size_t next = (k + 1) % ends.size();
            while (!ends[next].enters) {
                next = (next + 1) % ends.size();
            }
            following[ends[k].chain] = ends[next];
        }
    }
    return following;
}

}  // namespace

std::vector<Chain> closed_along_border(std::vector<Chain> chains, double width, double height) {
    const Border border(width, height);
    // Clang 14 does not compile std::ranges::stable_partition.
    const auto first_open = std::stable_partition(
        chains.begin(), chains.end(), [](const Chain& chain) { return chain.is_closed; });
    std::vector<Chain> open(std::make_move_iterator(first_open),
                            std::make_move_iterator(chains.end()));
    chains.erase(first_open, chains.end());
    const std::vector<BorderEnd> following = followers(open, border);
    std::vector<bool> used(open.size(), false);
    for (std::size_t start = 0; start < open.size(); ++start) {
        if (used[start]) {
            continue;
        }
        Chain loop{open[start].tail, {}, true};
        std::size_t k = start;
        do {
            used[k] = true;
            std::ranges::copy(open[k].steps, std::back_inserter(loop.steps));
            const BorderEnd& next = following[k];
            border.add_corners(border.position_of(loop.head()), next.position, loop);
            k = next.chain;
            Border::add_line(open[k].tail, loop);
        } while (!used[k]);
        chains.push_back(std::move(loop));
    }
    return chains;
}

}  // namespace foam::texgen
