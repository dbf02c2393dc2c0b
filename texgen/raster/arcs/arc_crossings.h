#pragma once

#include "texgen/raster/arcs/rising_arc.h"
#include "texgen/raster/coords/fixed_point.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// An arc that rises, from its lower end, in subpixels; its crossings are rounded to the nearest.
/// They are found in floats, to 1/10 of a subpixel, where these hold them so well; in doubles of
/// arcs that are longer.
class SubpixelArc {
  public:
    SubpixelArc() = default;
    /// As RisingArcOf.
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

/// Where an arc crosses heights y, y + step, ..., or places x, x + step, ..., moved by an offset
/// and mirrored.
struct ArcCrossings {
    static constexpr std::size_t kLanes = 8;  // found at once

    SubpixelArc arc;
    std::int32_t first = 0;
    std::int32_t step = 0;
    std::int32_t offset = 0;
    std::int32_t sign = 1;  // or -1
    std::size_t count = 0;
    std::size_t place = 0;  // of the first among the results, with room for whole vectors

    /// The place for those of the next arc.
    std::size_t end() const { return place + (count + kLanes - 1) / kLanes * kLanes; }
};

/// Of several arcs, none of which has to wait for the roots of another. Each as SubpixelArc has it.
void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs);
void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys);

}  // namespace foam::texgen
