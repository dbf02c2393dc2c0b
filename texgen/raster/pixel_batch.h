#pragma once

#include "core/geometry/vec2.h"

#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// A function like Quadratic at the middle of a batch, in floats.
struct FloatQuadratic {
    float twice_value = 0.0F;
    float x = 0.0F;  // its gradient
    float y = 0.0F;
    float curvature = 0.0F;
};

/// The same of a linear one, a distance from a line.
struct FloatLine {
    float value = 0.0F;
    float x = 0.0F;
    float y = 0.0F;
};

/// Some pixels of a region, close together: their distances and smooth distances, from arcs that
/// are added one by one. All arithmetic is in floats relative to the batch's middle, where the
/// arcs' functions are known: so nothing cancels, and how far the arcs reach does not matter. What
/// a pixel gets does not depend on which others are in its batch.
class PixelBatch {
  public:
    static constexpr std::size_t kCapacity = 1600;
    static constexpr std::size_t kLanes = 8;  // that are measured at once
    static constexpr double kMargin = 0.01;   // more than its floats are wrong by, pixels
    using Values = std::array<float, kCapacity + kLanes>;

    /// Neighbouring pixels of a row, in the region's coordinates.
    struct Run {
        int column = 0;
        int row = 0;
        std::size_t first = 0;  // of the batch's values
        std::size_t count = 0;
    };

    /// Begins anew, with no pixels; the middle lies at whole or half pixels.
    void clear(const Vec2& middle);
    /// Precondition: there is room.
    void add_run(int column, int row, int count) {
        const auto size = static_cast<std::size_t>(count);
        runs_[run_count_++] = {column, row, count_, size};
        const auto x = static_cast<float>(column + 0.5 - middle_.x());
        const auto y = static_cast<float>(row + 0.5 - middle_.y());
        for (std::size_t begin = 0; begin < size; begin += kLanes) {  // may write some too many
            const float first = x + static_cast<float>(static_cast<int>(begin));
            for (std::size_t k = 0; k < kLanes; ++k) {
                x_[count_ + begin + k] = first + kSteps[k];
                y_[count_ + begin + k] = y;
            }
        }
        count_ += size;
    }

    const Vec2& middle() const { return middle_; }
    std::span<const Run> runs() const { return std::span(runs_).first(run_count_); }
    bool is_empty() const { return count_ == 0; }

    /// Begins the distances, with infinity.
    void begin();
    /// An arc by the function across it and the lines at its ends. Counts where pixels face it.
    void add_arc(const FloatQuadratic& across, const FloatLine& tail, const FloatLine& head);
    /// The same, for gradients too.
    void add_arc_and_gradient(const FloatQuadratic& across,
                              const FloatLine& tail,
                              const FloatLine& head);
    /// A point, relative to the middle.
    void add_point(const Vec2& point);
    /// Whether a pixel faces none of the arcs, and no point was added.
    bool is_unresolved() const;
    /// Makes distances of what the nearest arcs and points are to the pixels.
    void finish();
    /// Makes unit vectors of the gradients. Before that they are of any length.
    void normalize_gradients();

    /// Begins the smooth distances.
    void begin_smooth();
    /// A film, by the functions across and along it.
    void add_film(const FloatQuadratic& across, const FloatQuadratic& along, float chord);
    /// Makes the sums of all films smooth distances. Where there are none it is the distance; its
    /// gradient has to be normalized before.
    void finish_smooth();

    const Values& distance() const { return distance_; }
    const Values& gradient_x() const { return gradient_x_; }
    const Values& gradient_y() const { return gradient_y_; }
    const Values& smooth() const { return smooth_; }
    const Values& smooth_x() const { return smooth_x_; }
    const Values& smooth_y() const { return smooth_y_; }

  private:
    static constexpr std::array<float, kLanes> kSteps{0, 1, 2, 3, 4, 5, 6, 7};

    Vec2 middle_{0.0, 0.0};
    std::size_t count_ = 0;
    std::size_t padded_ = 0;  // to whole vectors
    std::size_t run_count_ = 0;
    std::array<Run, kCapacity> runs_;
    alignas(32) Values x_{};  // from the middle
    alignas(32) Values y_{};
    // The distance as a fraction, which is compared without being divided: that is done once for a
    // pixel, and not for each of its arcs.
    alignas(32) Values over_{};
    alignas(32) Values under_{};
    alignas(32) Values distance_{};
    alignas(32) Values gradient_x_{};
    alignas(32) Values gradient_y_{};
    alignas(32) Values smooth_{};  // sums, until they are finished
    alignas(32) Values smooth_x_{};
    alignas(32) Values smooth_y_{};
};

}  // namespace foam::texgen
