// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/node_graph.h"
#include "core/sparse/vertex_cut.h"
#include "core/sparse/zone.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// Options of SeparatorSearch.
struct SeparatorOptions {
    // The separator is sought in a band along the border of the two zones. In each zone the band
    // consists of the nodes that have a neighbor in the other zone, and of `band_layers` further
    // layers. A further layer consists of the neighbors of the layer before it.
    int band_layers = 1;
    // A further layer is not added if more than this fraction of the nodes of its zone would then
    // be in the band.
    double band_fraction = 0.4;
};

/// Finds the lightest separator (the separator with the fewest rows) near the common border of two
/// zones.
class SeparatorSearch {
  public:
    static constexpr std::uint32_t kNotInBand = std::numeric_limits<std::uint32_t>::max();

    /// `zones` and `band_indices` have one element per node of the graph. All elements of
    /// `band_indices` are kNotInBand on entry and between calls of `separate`. Different
    /// SeparatorSearch objects may use the same `zones` and `band_indices` at the same time if they
    /// divide parts of the graph that are not coupled to each other.
    SeparatorSearch(const NodeGraph& graph,
                    std::span<const SolverNode> nodes,
                    const SeparatorOptions& options,
                    std::span<Zone> zones,
                    std::span<std::uint32_t> band_indices)
        : graph_(graph),
          nodes_(nodes),
          options_(options),
          zones_(zones),
          band_indices_(band_indices) {}

    /// Finds the lightest separator in a band along the border of the zones Low and High, and moves
    /// its nodes to the zone Outside. Each other node of the band moves to the zone on its side of
    /// the separator. No node of the zone Low is then coupled to a node of the zone High.
    /// Precondition: `part` holds the nodes of both zones, and half of these nodes are in each
    /// zone.
    void separate(std::span<const std::uint32_t> part);

  private:
    std::size_t grow_band(std::span<const std::uint32_t> part, Zone zone);
    void add_border(std::span<const std::uint32_t> part, Zone zone);
    void add_layer(std::size_t rim, Zone zone);
    bool touches(std::uint32_t node, Zone zone) const;
    void add_to_band(std::uint32_t node);
    void drop_from(std::size_t begin);
    void pose_cut(std::size_t low_rim, std::size_t low_end, std::size_t high_rim);

    const NodeGraph& graph_;
    std::span<const SolverNode> nodes_;
    SeparatorOptions options_;
    std::span<Zone> zones_;
    std::span<std::uint32_t> band_indices_;
    std::vector<std::uint32_t> band_;  // nodes of the band, first in Low, then in High
    VertexCut cut_;
};

}  // namespace foam
