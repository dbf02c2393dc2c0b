// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/separator.h"

#include <algorithm>

namespace foam {

// The band is grown by breadth-first search from the border between the zones. The last layer that
// was added in each zone is the rim. The nodes of the rim in Low are the sources of a minimum
// vertex cut, the nodes of the rim in High are the sinks, and the weight of a node is its number of
// rows. If a node of a zone is outside the band, its only neighbors in the band are in the rim of
// this zone. So the cut separates the zones.

void SeparatorSearch::separate(std::span<const std::uint32_t> part) {
    band_.clear();
    const std::size_t low_rim = grow_band(part, Zone::Low);
    const std::size_t low_end = band_.size();
    const std::size_t high_rim = grow_band(part, Zone::High);
    pose_cut(low_rim, low_end, high_rim);
    const std::vector<CutSide>& sides = cut_.solve();
    for (std::size_t k = 0; k < band_.size(); ++k) {
        band_indices_[band_[k]] = kNotInBand;
        zones_[band_[k]] = sides[k] == CutSide::Source ? Zone::Low
                           : sides[k] == CutSide::Sink ? Zone::High
                                                       : Zone::Outside;
    }
}

// Adds layers of a zone to the band, beginning with the nodes that touch the other zone. Stops when
// the band has enough layers, when the next layer would make it too large (SeparatorOptions), or
// when the next layer is empty. Returns the index in the band at which the last layer, the rim,
// begins.
std::size_t SeparatorSearch::grow_band(std::span<const std::uint32_t> part, Zone zone) {
    const std::size_t begin = band_.size();
    add_border(part, zone);
    const auto zone_size = static_cast<double>(part.size()) / 2.0;
    const auto max_size = begin + static_cast<std::size_t>(options_.band_fraction * zone_size);
    std::size_t rim = begin;
    for (int layer = 0; layer < options_.band_layers; ++layer) {
        const std::size_t end = band_.size();
        add_layer(rim, zone);
        if (band_.size() > max_size || band_.size() == end) {
            drop_from(end);
            break;
        }
        rim = end;
    }
    return rim;
}

void SeparatorSearch::add_border(std::span<const std::uint32_t> part, Zone zone) {
    for (const std::uint32_t node : part) {
        if (zones_[node] == zone && touches(node, opposite(zone))) {
            add_to_band(node);
        }
    }
}

void SeparatorSearch::add_layer(std::size_t rim, Zone zone) {
    const std::size_t end = band_.size();
    for (std::size_t k = rim; k < end; ++k) {
        for (const std::uint32_t neighbor : graph_.neighbors_of(band_[k])) {
            if (zones_[neighbor] == zone && band_indices_[neighbor] == kNotInBand) {
                add_to_band(neighbor);
            }
        }
    }
}

bool SeparatorSearch::touches(std::uint32_t node, Zone zone) const {
    const std::span<const std::uint32_t> neighbors = graph_.neighbors_of(node);
    return std::any_of(neighbors.begin(), neighbors.end(), [&](std::uint32_t neighbor) {
        return zones_[neighbor] == zone;
    });
}

void SeparatorSearch::add_to_band(std::uint32_t node) {
    band_indices_[node] = static_cast<std::uint32_t>(band_.size());
    band_.push_back(node);
}

void SeparatorSearch::drop_from(std::size_t begin) {
    for (std::size_t k = begin; k < band_.size(); ++k) {
        band_indices_[band_[k]] = kNotInBand;
    }
    band_.resize(begin);
}

// Sets up the cut problem. The sources are the rim in the zone Low, the indices [low_rim, low_end)
// of the band. The sinks are the rim in the zone High, the indices from high_rim on.
void SeparatorSearch::pose_cut(std::size_t low_rim, std::size_t low_end, std::size_t high_rim) {
    const auto is_source = [&](std::size_t k) { return k >= low_rim && k < low_end; };
    cut_.reset(band_.size());
    for (std::size_t k = 0; k < band_.size(); ++k) {
        cut_.set_weight(k, nodes_[band_[k]].rows);
        if (k >= high_rim) {
            cut_.make_sink(k);
            continue;
        }
        if (is_source(k)) {
            cut_.make_source(k);
        }
        for (const std::uint32_t neighbor : graph_.neighbors_of(band_[k])) {
            const std::size_t index = band_indices_[neighbor];
            if (index != kNotInBand && !is_source(index)) {
                cut_.connect(k, index);
            }
        }
    }
}

}  // namespace foam
