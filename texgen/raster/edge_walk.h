#pragma once

#include "texgen/raster/fixed_point.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// What a chain of edges does in one pixel. To all pixels on its right in the row it adds its
/// height; of the pixel itself, it leaves the area on its left out.
struct PixelPart {
    std::int32_t row = -1;
    std::int32_t column = 0;
    // Subpixels; positive on the way down, where a counter-clockwise outline begins.
    std::int32_t height = 0;
    std::int32_t area = 0;  // on its left, in half square subpixels, with the sign of the height
};

/// Splits chains into pixel parts, for rows [0, rows), and hands them to a sink, any number of them
/// for a pixel. An edge is split the same way in both directions and wherever whole pixels
/// move it, so that the parts of two chains that share it cancel.
template <class Sink>
class EdgeWalk {
  public:
    EdgeWalk(int rows, Sink sink) : top_(rows * kSubpixel), sink_(sink) {}

    /// A closed chain.
    void walk(std::span<const SubpixelPoint> chain, SubpixelPoint translation) {
        walk(chain, 0, chain.size(), translation);
    }

    /// Of a closed chain the edges that lead to the points [begin, end).
    void walk(std::span<const SubpixelPoint> chain,
              std::size_t begin,
              std::size_t end,
              SubpixelPoint translation);

  private:
    // What lies of an edge within one row; y from the row's lower end, y0 < y1.
    struct RowEdge {
        std::int32_t x0;
        std::int32_t y0;
        std::int32_t x1;
        std::int32_t y1;
    };

    // To the nearest, ties up; |x| < 2^30.
    static std::int32_t rounded(double x) {
        constexpr std::int32_t kBias = 1
                                       << 30;  // makes the sum positive, where truncation is floor
        return static_cast<std::int32_t>(x + (kBias + 0.5)) - kBias;
    }

    void add_edge(SubpixelPoint low, SubpixelPoint high, std::int32_t sign);
    void add_in_row(std::int32_t row, const RowEdge& edge, std::int32_t sign);

    std::int32_t top_;  // subpixels
    Sink sink_;
};

template <class Sink>
void EdgeWalk<Sink>::walk(std::span<const SubpixelPoint> chain,
                          std::size_t begin,
                          std::size_t end,
                          SubpixelPoint translation) {
    if (begin == end) {
        return;
    }
    SubpixelPoint from = (begin == 0 ? chain.back() : chain[begin - 1]) + translation;
    for (const SubpixelPoint point : chain.subspan(begin, end - begin)) {
        const SubpixelPoint to = point + translation;
        const bool in_rows = std::max(from.y, to.y) > 0 && std::min(from.y, to.y) < top_;
        if (in_rows && from.y < to.y) {
            add_edge(from, to, -1);
        } else if (in_rows && to.y < from.y) {
            add_edge(to, from, 1);
        }
        from = to;
    }
}

template <class Sink>
inline void EdgeWalk<Sink>::add_edge(SubpixelPoint low, SubpixelPoint high, std::int32_t sign) {
    const std::int32_t end = std::min(high.y, top_);
    std::int32_t row = std::max(pixel_of(low.y), 0);
    std::int32_t base = row * kSubpixel;
    if (base <= low.y && high.y <= base + kSubpixel) {
        add_in_row(row, {low.x, low.y - base, high.x, high.y - base}, sign);
        return;
    }
    const double slope = static_cast<double>(high.x - low.x) / (high.y - low.y);
    const auto x_at = [&](std::int32_t y) { return low.x + rounded(slope * (y - low.y)); };
    std::int32_t y = std::max(low.y, 0);
    std::int32_t x = x_at(y);
    for (; y < end; ++row, base += kSubpixel) {
        const std::int32_t next_y = std::min(base + kSubpixel, end);
        const std::int32_t next_x = next_y == high.y ? high.x : x_at(next_y);
        add_in_row(row, {x, y - base, next_x, next_y - base}, sign);
        x = next_x;
        y = next_y;
    }
}

template <class Sink>
void EdgeWalk<Sink>::add_in_row(std::int32_t row, const RowEdge& edge, std::int32_t sign) {
    std::int32_t column = pixel_of(edge.x0);
    const std::int32_t last = pixel_of(edge.x1);
    std::int32_t x = edge.x0;
    std::int32_t y = edge.y0;
    if (column != last) {
        const double steepness = static_cast<double>(edge.y1 - edge.y0) / (edge.x1 - edge.x0);
        const std::int32_t step = column < last ? 1 : -1;
        const std::int32_t far_side = column < last ? kSubpixel : 0;
        for (; column != last; column += step) {
            const std::int32_t left = column * kSubpixel;
            const std::int32_t border = left + far_side;
            const std::int32_t next_y = edge.y0 + rounded(steepness * (border - edge.x0));
            const std::int32_t height = sign * (next_y - y);
            sink_(PixelPart{row, column, height, height * (x + border - 2 * left)});
            x = border;
            y = next_y;
        }
    }
    const std::int32_t height = sign * (edge.y1 - y);
    sink_(PixelPart{row, last, height, height * (x + edge.x1 - 2 * last * kSubpixel)});
}

}  // namespace foam::texgen
