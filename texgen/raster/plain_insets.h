#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/inset.h"
#include "texgen/raster/side_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// The insets of some bubbles of which every side shows: their sides' offsets, each cut off where
/// it crosses those of the sides beside it. Most bubbles are of that kind; one is said to be only
/// where it is certain, by checks that cost little. What is found has the bits of InsetTracer's.
///
/// The sides of all bubbles lie in lanes, one after the other, so that several are worked on at
/// once. After the last side of a bubble its first one is there again: what comes next to a side
/// is always in the next lane.
class PlainInsets {
  public:
    static constexpr std::size_t kMostBubbles = 16;
    static constexpr std::size_t kMostSides = 16;  // of each

    void clear() { bubbles_ = 0; }

    /// One more bubble, by its sides, counter-clockwise: side_of(k) is a PixelArc, whose chord may
    /// be zero. The origin is at the tail of the first. Precondition: 0 < sides <= kMostSides.
    template <class SideOf>
    void add(std::size_t sides, const SideOf& side_of) {
        const std::size_t first = begin(bubbles_);
        Vec2 tail = Vec2::Zero();
        for (std::size_t k = 0; k < sides; ++k) {
            const PixelArc side = side_of(k);
            set_side(first + k, side, tail);
            tail += side.chord;
        }
        set_side(first + sides, side_of(0), Vec2::Zero());
        begins_[++bubbles_] = first + sides + 1;
    }

    /// distance > 0, in pixels.
    void trace(double distance);

    /// Whether the inset of a bubble is plain for certain. If so, its arcs are in these lanes, and
    /// the first is once more in the lane where they end, as far as its tail.
    bool is_certain(std::size_t bubble) const { return certain_[bubble]; }
    std::size_t begin(std::size_t bubble) const { return begins_[bubble]; }
    std::size_t end(std::size_t bubble) const { return begins_[bubble + 1] - 1; }

    ArcLoops::Arc arc(std::size_t lane) const {
        return {{tail_x_[lane], tail_y_[lane]},
                {{ahead_x_[lane], ahead_y_[lane]}, cosine_[lane], sine_[lane]}};
    }
    double sine(std::size_t lane) const { return sine_[lane]; }
    SubpixelPoint rounded_tail(std::size_t lane) const {
        return {rounded_x_[lane], rounded_y_[lane]};
    }
    bool is_monotone(std::size_t lane) const { return monotone_[lane] != 0; }

  private:
    // Bubbles are also taken one by one, in blocks of lanes of which the last reaches beyond them.
    static constexpr std::size_t kBlock = 8;
    static constexpr std::size_t kLanes = kMostBubbles * (kMostSides + 1) + kBlock;
    using Lanes = std::array<double, kLanes>;
    using Flags = std::array<std::int64_t, kLanes>;  // as wide as the others
    // The arcs of each bubble, and then once more, so that those from any one on lie together.
    using Rounds = std::array<double, 2 * kLanes + kBlock>;

    void set_side(std::size_t k, const PixelArc& side, const Vec2& tail) {
        side_tail_x_[k] = tail.x();
        side_tail_y_[k] = tail.y();
        chord_x_[k] = side.chord.x();
        chord_y_[k] = side.chord.y();
        side_cosine_[k] = side.cosine;
        side_sine_[k] = side.sine;
    }
    std::size_t lanes() const { return begins_[bubbles_]; }
    [[gnu::always_inline]] ArcCircle offset_circle(std::size_t k) const {
        return {offset_x_[k], offset_y_[k], along_x_[k], along_y_[k], offset_curvature_[k]};
    }

    void place_offsets(double distance);
    void cross_offsets();
    void cut_offsets();
    void join_arcs();
    void copy_arcs();
    void copy_round(std::size_t bubble, std::size_t to);
    void measure_distances(double distance);
    void measure_distances(std::size_t bubble, double distance);
    bool decide(std::size_t bubble) const;
    bool keeps_clear(std::size_t bubble, std::size_t side) const;

    std::size_t bubbles_ = 0;
    std::array<std::size_t, kMostBubbles + 1> begins_{};
    std::array<bool, kMostBubbles> certain_{};

    // Sides, with unit tangents in their middles and at their ends.
    Lanes side_tail_x_{}, side_tail_y_{}, chord_x_{}, chord_y_{}, side_cosine_{}, side_sine_{};
    Lanes middle_x_{}, middle_y_{}, along_x_{}, along_y_{}, curvature_{};
    Lanes tail_along_x_{}, tail_along_y_{}, head_along_x_{}, head_along_y_{};
    // Their offsets, as of SideArc, and the parameters between which they show.
    Lanes offset_x_{}, offset_y_{}, offset_curvature_{}, reach_{}, from_{}, to_{};
    // What shows.
    Lanes tail_x_{}, tail_y_{}, ahead_x_{}, ahead_y_{}, cosine_{}, sine_{};
    std::array<std::int32_t, kLanes> rounded_x_{}, rounded_y_{};
    Flags monotone_{};
    Rounds round_x_{}, round_y_{}, round_curvature_{};
    // Why it may not be plain: because of a side and the corner at its head; and of what else
    // shows near to it.
    Flags corner_doubts_{}, side_doubts_{};
    std::array<std::int64_t, kMostBubbles> doubts_{};
};

}  // namespace foam::texgen
