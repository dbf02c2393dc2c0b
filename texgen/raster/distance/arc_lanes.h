#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Arcs in structure-of-arrays layout, and what each of them is near a point: the functions that
/// its distance is made of, and bounds of the distance. Eight arcs are computed at once.
class ArcLanes {
  public:
    /// The least cosine of the half angle of an arc that bounds a region. Wider arcs are halved, as
    /// the half planes at the ends of an arc tell what faces it only if it turns by less.
    static constexpr double kLeastCosine = 0.5;

    void clear();
    /// Adds an arc of at least kShortestSide. `corner` says whether the region has an angle of more
    /// than 180 degrees at the tail, so that the tail itself may be the nearest point.
    void add(const PixelArc& shape, const Vec2& tail, bool corner);
    /// Adds arc k of another set.
    void add(const ArcLanes& other, std::size_t k);

    std::size_t size() const { return size_; }

    /// Computes the functions and bounds of all arcs at a point. The members below refer to it.
    void evaluate_at(const Vec2& point);

    /// Returns an upper bound of the distance between any point within reach of the point and its
    /// nearest arc, plus reach: farther arcs are not nearest to any such point.
    double horizon(double reach) const;
    bool is_within(std::size_t k, double horizon) const {
        return at(&Block::at_least, k) <= horizon;
    }
    /// Returns true if the tail of the arc may be the nearest point of the region's boundary.
    bool has_corner(std::size_t k) const { return corners_[k] != 0; }
    bool has_corners() const { return corner_count_ > 0; }
    Vec2 tail(std::size_t k) const { return {at(&Block::tail_x, k), at(&Block::tail_y, k)}; }
    Vec2 head(std::size_t k) const {
        return tail(k) + Vec2(at(&Block::chord_x, k), at(&Block::chord_y, k));
    }
    double chord(std::size_t k) const { return at(&Block::chord, k); }
    ArcFunctions functions(std::size_t k) const;
    FilmFunctions film_functions(std::size_t k) const;

  private:
    static constexpr std::size_t kLanes = 8;
    using Lanes = std::array<double, kLanes>;
    using FloatLanes = std::array<float, kLanes>;

    // Eight arcs and what is computed of them. Lanes beyond the last arc are not used.
    struct alignas(64) Block {
        Lanes tail_x, tail_y, chord_x, chord_y, cosine, sine;
        Lanes chord, twice, slope_x, slope_y, past_tail, before_head, at_least, facing;
        FloatLanes twice_float, slope_x_float, slope_y_float, curvature_float;
        FloatLanes tail_float, tail_x_float, tail_y_float, head_float, head_x_float, head_y_float;
        FloatLanes along_float, along_x_float, along_y_float, along_curvature_float;
    };

    // Intermediate results of a block.
    struct Terms {
        Lanes over_chord, direction_x, direction_y;
        Lanes along, along_x, along_y;  // the function t of evaluate_at and its gradient
    };

    static void find_directions(Block& b, Terms& terms);
    static void find_functions(double x, double y, Block& b, Terms& terms);
    static void find_bounds(Block& b);
    static void convert_to_floats(Block& b, const Terms& terms);
    template <class Value>
    Value at(std::array<Value, kLanes> Block::*column, std::size_t k) const {
        return (blocks_[k / kLanes].*column)[k % kLanes];
    }

    std::size_t size_ = 0;
    std::size_t corner_count_ = 0;
    std::vector<Block> blocks_;
    std::vector<std::uint8_t> corners_;
};

}  // namespace foam::texgen
