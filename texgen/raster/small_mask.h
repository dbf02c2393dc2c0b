#pragma once

#include "texgen/raster/side_lanes.h"
#include "texgen/raster/snapped_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// The pixels of a small bubble, a word for each row: those that a CellMask has of the same sides
/// by way of RowCrossings, in less time.
class SmallMask {
  public:
    static constexpr int kMostColumns = 40;
    static constexpr int kMostRows = 40;
    static constexpr int kGroup = 8;  // rows that are crossed at once

    struct Rows {
        int begin = 0;
        int end = 0;
    };

    /// Of at most kLanes sides, which are moved to be relative to the lower left corner of the
    /// mask. Only the rows named are found. Whether there was room for the pieces of the sides.
    bool fill(const SideLanes& sides, SubpixelPoint translation, int columns, const Rows& rows);

    /// The first pixel in the lowest bit.
    std::uint64_t row(int k) const { return rows_[static_cast<std::size_t>(k)]; }

  private:
    static constexpr std::size_t kLanes = SideLanes::kLanes;
    static constexpr std::size_t kMostPieces = 2 * kLanes;
    template <class Value>
    using Lanes = SideLanes::Lanes<Value>;

    // Arcs that rise, or have no height and are left out.
    struct alignas(64) Rising {
        Lanes<std::int32_t> low_x;
        Lanes<std::int32_t> low_y;
        Lanes<std::int32_t> high_x;
        Lanes<std::int32_t> high_y;
        Lanes<double> cosine;
        Lanes<double> sine;
    };

    static std::uint32_t orient(const SideLanes& sides, SubpixelPoint translation, Rising& rising);
    bool split(const SideLanes& sides, SubpixelPoint translation, std::size_t side);
    bool put(std::size_t k, const SnappedArc& piece);
    static void cross(const Rising& arcs, int columns, const Rows& rows, std::uint64_t* words);

    std::array<Rising, kMostPieces / kLanes> rising_{};
    std::size_t pieces_ = 0;
    std::array<std::uint64_t, kMostRows + kGroup> rows_{};
};

}  // namespace foam::texgen
