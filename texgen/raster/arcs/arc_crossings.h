#pragma once

#include "texgen/raster/arcs/rising_arc.h"
#include "texgen/raster/coords/fixed_point.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// A rising arc in subpixels, from its lower end; crossings are rounded to the nearest. For arcs of
/// up to 256 pixels they are computed in floats, to 1/10 of a subpixel; for longer ones in doubles.
class SubpixelArc {
  public:
    SubpixelArc() = default;
    /// See RisingArcOf.
    SubpixelArc(SubpixelPoint head, double sine)
        : head_(head.x, head.y), sine_(sine), in_floats_(head_, sine_) {}

    bool is_short() const { return std::abs(head_.x()) <= kLongest && head_.y() <= kLongest; }
    const RisingArcOf<float>& in_floats() const { return in_floats_; }
    RisingArcOf<double> in_doubles() const { return {head_, sine_}; }

    std::int32_t x_at(std::int32_t y) const {
        return is_short() ? rounded(in_floats().x_at(static_cast<float>(y)))
                          : rounded(in_doubles().x_at(y));
    }

  private:
    static constexpr double kLongest = 256 * kSubpixel;  // along x and y, of short ones

    Vec2 head_{0.0, 1.0};
    double sine_ = 0.0;
    RisingArcOf<float> in_floats_;
};

/// A query for the crossings of an arc with heights y, y + step, ..., or columns x, x + step, ...;
/// the results are moved by an offset and mirrored by a sign.
struct ArcCrossings {
    static constexpr std::size_t kLanes = 8;  // computed at once

    SubpixelArc arc;
    std::int32_t first = 0;
    std::int32_t step = 0;
    std::int32_t offset = 0;
    std::int32_t sign = 1;  // or -1
    std::size_t count = 0;
    std::size_t position = 0;  // of the first among the results, with room for whole vectors

    /// Returns the position for the results of the next query.
    std::size_t end() const { return position + (count + kLanes - 1) / kLanes * kLanes; }
};

/// Computes the crossings of several arcs, which do not wait for each other's square roots.
void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs);
void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys);

}  // namespace foam::texgen
