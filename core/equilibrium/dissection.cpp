#include "core/equilibrium/dissection.h"

#include "core/equilibrium/vertex_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace foam {

namespace {

// A rectangle around the nodes of a part, but for a few at its rim.
struct Box {
    Vec2 low;
    Vec2 high;
};

using Nodes = std::span<std::uint32_t>;

enum class Zone : std::uint8_t { Outside, Low, High };

class Dissector {
  public:
    Dissector(const NodeGraph& graph,
              std::span<const SolverNode> nodes,
              const Torus& torus,
              const DissectionOptions& options)
        : graph_(graph),
          nodes_(nodes),
          periods_(torus.width, torus.height),
          options_(options),
          zones_(nodes.size(), Zone::Outside),
          keys_(nodes.size()),
          places_(nodes.size(), kNoPlace) {}

    Dissection run() && {
        result_.order.resize(nodes_.size());
        std::iota(result_.order.begin(), result_.order.end(), 0U);
        dissect(0, nodes_.size(), {Vec2::Zero(), periods_});
        return std::move(result_);
    }

  private:
    static constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();

    std::size_t dissect(std::size_t begin, std::size_t end, const Box& box) {
        const Nodes part = Nodes(result_.order).subspan(begin, end - begin);
        if (rows_of(part) <= options_.leaf_rows) {
            return add_part({begin, end});
        }
        const Eigen::Index axis = box.high.x() - box.low.x() < box.high.y() - box.low.y() ? 1 : 0;
        const double cut = halve(part, box, axis);
        move_cut(part);
        const auto [low, high] = sort_by_zone(part);
        if (low == 0 || high == 0) {
            return add_part({begin, end});
        }
        Box low_box = box;
        Box high_box = box;
        low_box.high[axis] = high_box.low[axis] = cut;
        const std::size_t left = dissect(begin, begin + low, low_box);
        const std::size_t right = dissect(begin + low, begin + low + high, high_box);
        return add_part({begin + low + high, end, left, right});
    }

    std::size_t add_part(const DissectionPart& part) {
        result_.parts.push_back(part);
        return result_.parts.size() - 1;
    }

    int rows_of(Nodes part) const {
        int rows = 0;
        for (const std::uint32_t node : part) {
            rows += nodes_[node].rows;
        }
        return rows;
    }

    // Gives each half its zone, and returns the coordinate between them. Coordinates are taken
    // around the middle of the box, so that one slightly beyond an edge stays near it.
    double halve(Nodes part, const Box& box, Eigen::Index axis) {
        const double middle = 0.5 * (box.low[axis] + box.high[axis]);
        for (const std::uint32_t node : part) {
            const double from_middle = nodes_[node].position[axis] - middle;
            keys_[node] = from_middle - periods_[axis] * std::round(from_middle / periods_[axis]);
        }
        const std::size_t half = part.size() / 2;
        std::nth_element(part.begin(),
                         part.begin() + static_cast<std::ptrdiff_t>(half),
                         part.end(),
                         [this](std::uint32_t a, std::uint32_t b) {
                             return std::pair(keys_[a], a) < std::pair(keys_[b], b);
                         });
        for (std::size_t k = 0; k < part.size(); ++k) {
            zones_[part[k]] = k < half ? Zone::Low : Zone::High;
        }
        return middle + keys_[part[half]];
    }

    // Takes the lightest cut in a band along the border of the zones out of both of them, and lets
    // the band's other nodes change sides accordingly.
    void move_cut(Nodes part) {
        band_.clear();
        const std::size_t low_rim = grow_band(part, Zone::Low);
        const std::size_t low_end = band_.size();
        const std::size_t high_rim = grow_band(part, Zone::High);
        pose_cut(low_rim, low_end, high_rim);
        const std::vector<CutSide>& sides = cut_.solve();
        for (std::size_t k = 0; k < band_.size(); ++k) {
            places_[band_[k]] = kNoPlace;
            zones_[band_[k]] = sides[k] == CutSide::Source ? Zone::Low
                               : sides[k] == CutSide::Sink ? Zone::High
                                                           : Zone::Outside;
        }
    }

    // Adds layer after layer of a zone to the band, from the nodes that touch the other zone on.
    // Returns where the last layer begins.
    std::size_t grow_band(Nodes part, Zone zone) {
        const std::size_t begin = band_.size();
        add_border(part, zone);
        const auto zone_size = static_cast<double>(part.size()) / 2.0;
        const auto most = begin + static_cast<std::size_t>(options_.band_share * zone_size);
        std::size_t rim = begin;
        for (int layer = 0; layer < options_.band_layers; ++layer) {
            const std::size_t end = band_.size();
            add_layer(rim, zone);
            if (band_.size() > most || band_.size() == end) {
                drop_from(end);
                break;
            }
            rim = end;
        }
        return rim;
    }

    void add_border(Nodes part, Zone zone) {
        const Zone other = zone == Zone::Low ? Zone::High : Zone::Low;
        for (const std::uint32_t node : part) {
            if (zones_[node] == zone && touches(node, other)) {
                add_to_band(node);
            }
        }
    }

    void add_layer(std::size_t rim, Zone zone) {
        const std::size_t end = band_.size();
        for (std::size_t k = rim; k < end; ++k) {
            for (const std::uint32_t neighbour : graph_.of(band_[k])) {
                if (zones_[neighbour] == zone && places_[neighbour] == kNoPlace) {
                    add_to_band(neighbour);
                }
            }
        }
    }

    bool touches(std::uint32_t node, Zone zone) const {
        const std::span<const std::uint32_t> neighbours = graph_.of(node);
        return std::any_of(neighbours.begin(), neighbours.end(), [&](std::uint32_t neighbour) {
            return zones_[neighbour] == zone;
        });
    }

    void add_to_band(std::uint32_t node) {
        places_[node] = static_cast<std::uint32_t>(band_.size());
        band_.push_back(node);
    }

    void drop_from(std::size_t begin) {
        for (std::size_t k = begin; k < band_.size(); ++k) {
            places_[band_[k]] = kNoPlace;
        }
        band_.resize(begin);
    }

    // Sources are the nodes from low_rim to low_end, sinks those from high_rim on.
    void pose_cut(std::size_t low_rim, std::size_t low_end, std::size_t high_rim) {
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
            for (const std::uint32_t neighbour : graph_.of(band_[k])) {
                const std::size_t place = places_[neighbour];
                if (place != kNoPlace && !is_source(place)) {
                    cut_.connect(k, place);
                }
            }
        }
    }

    // Sorts the part into low nodes, high nodes and the cut, and takes all out of their zones.
    // Returns the numbers of the low and of the high nodes.
    std::pair<std::size_t, std::size_t> sort_by_zone(Nodes part) {
        const auto in = [this](Zone zone) {
            return [this, zone](std::uint32_t node) { return zones_[node] == zone; };
        };
        const auto low_end = std::stable_partition(part.begin(), part.end(), in(Zone::Low));
        const auto high_end = std::stable_partition(low_end, part.end(), in(Zone::High));
        for (const std::uint32_t node : part) {
            zones_[node] = Zone::Outside;
        }
        return {static_cast<std::size_t>(low_end - part.begin()),
                static_cast<std::size_t>(high_end - low_end)};
    }

    const NodeGraph& graph_;
    std::span<const SolverNode> nodes_;
    Vec2 periods_;
    const DissectionOptions& options_;
    Dissection result_;
    std::vector<Zone> zones_;
    std::vector<double> keys_;           // coordinate by which a part is halved
    std::vector<std::uint32_t> places_;  // in the band
    std::vector<std::uint32_t> band_;
    VertexCut cut_;
};

}  // namespace

Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Torus& torus,
                   const DissectionOptions& options) {
    return Dissector(graph, nodes, torus, options).run();
}

}  // namespace foam
