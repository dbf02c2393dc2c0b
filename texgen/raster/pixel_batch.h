#pragma once

#include "core/geometry/vec2.h"

#include <array>
#include <cstddef>
#include <cstdint>
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

/// What an arc is to a batch: the function across it, and the lines that are normal to it at its
/// ends, from which the arc's own side counts as positive.
struct FloatArc {
    FloatQuadratic across;
    FloatLine tail;
    FloatLine head;
};

/// Some pixels of a region, close together: their distances and smooth distances, from arcs that
/// are added one by one. All arithmetic is in floats relative to the batch's middle, where the
/// arcs' functions are known: so nothing cancels, and how far the arcs reach does not matter. What
/// a pixel gets does not depend on which others are in its batch.
class PixelBatch {
  public:
    static constexpr std::size_t kCapacity = 1600;
    static constexpr std::size_t kLanes = 16;  // that are measured at once
    static constexpr double kMargin = 0.01;    // more than its floats are wrong by, pixels
    using Values = std::array<float, kCapacity + kLanes>;

    /// Neighbouring pixels of a row, in the region's coordinates.
    struct Run {
        int column = 0;
        int row = 0;
        std::uint32_t first = 0;  // of the batch's values
        std::uint32_t count = 0;
    };

    /// Begins anew, with no pixels; the middle lies at whole or half pixels.
    void clear(const Vec2& middle);
    /// Precondition: there is room.
    void add_run(int column, int row, int count) {
        const auto size = static_cast<std::size_t>(count);
        runs_[run_count_++] = {
            column, row, static_cast<std::uint32_t>(count_), static_cast<std::uint32_t>(count)};
        const float x = static_cast<float>(column) - first_x_;
        const float y = static_cast<float>(row) - first_y_;
        for (std::size_t begin = 0; begin < size; begin += kSteps.size()) {  // some too many
            const float first = x + static_cast<float>(static_cast<int>(begin));
            for (std::size_t k = 0; k < kSteps.size(); ++k) {
                x_[count_ + begin + k] = first + kSteps[k];
                y_[count_ + begin + k] = y;
            }
        }
        count_ += size;
    }

    const Vec2& middle() const { return middle_; }
    std::span<const Run> runs() const { return std::span(runs_).first(run_count_); }
    bool is_empty() const { return count_ == 0; }

    /// Begins the distances with arcs, each of which counts where pixels face it.
    void add_arcs(std::span<const FloatArc> arcs);
    /// The same, for gradients too.
    void add_arcs_and_gradients(std::span<const FloatArc> arcs);
    /// A point, relative to the middle.
    void add_point(const Vec2& point);
    /// Makes distances of what the nearest arcs and points are to the pixels. Whether each has one:
    /// else a pixel faces none of the arcs, and no point was added.
    bool finish();
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
    void pad();

    static constexpr std::array<float, 8> kSteps{0, 1, 2, 3, 4, 5, 6, 7};

    Vec2 middle_{0.0, 0.0};
    float first_x_ = 0.0F;  // the middle, from the centre of pixel (0, 0); exact
    float first_y_ = 0.0F;
    std::size_t count_ = 0;
    std::size_t padded_ = 0;  // to whole vectors
    std::size_t run_count_ = 0;
    std::array<Run, kCapacity> runs_;
    alignas(64) Values x_{};  // from the middle
    alignas(64) Values y_{};
    // The distance as a fraction, which is compared without being divided: that is done once for a
    // pixel, and not for each of its arcs.
    alignas(64) Values over_{};
    alignas(64) Values under_{};
    alignas(64) Values distance_{};
    alignas(64) Values gradient_x_{};
    alignas(64) Values gradient_y_{};
    alignas(64) Values smooth_{};  // sums, until they are finished
    alignas(64) Values smooth_x_{};
    alignas(64) Values smooth_y_{};
};

}  // namespace foam::texgen
