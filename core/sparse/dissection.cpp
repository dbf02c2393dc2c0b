#include "core/sparse/dissection.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/vertex_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace foam {

namespace {

constexpr int kFewRows = 2000;  // below, a second thread saves next to nothing

// A rectangle around the nodes of a part, but for a few at its rim.
struct Box {
    Vec2 low;
    Vec2 high;
};

// The plane's are so large that no coordinate reaches half of one.
Vec2 periods_of(const Domain& domain) {
    return domain.is_plane() ? Vec2(Vec2::Constant(std::numeric_limits<double>::max()))
                             : Vec2(domain.width, domain.height);
}

Box bounding_box(std::span<const SolverNode> nodes) {
    Box box{nodes.front().position, nodes.front().position};
    for (const SolverNode& node : nodes) {
        box.low = box.low.cwiseMin(node.position);
        box.high = box.high.cwiseMax(node.position);
    }
    return box;
}

using Nodes = std::span<std::uint32_t>;

enum class Zone : std::uint8_t { Outside, Low, High };

constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();

// One value per node. Parts of the graph that are dissected at the same time write different ones,
// and read none of each other's: the cut lies between them.
struct NodeMemory {
    std::vector<std::uint32_t> order;
    std::vector<Zone> zones;
    std::vector<double> keys;           // coordinate by which a part is halved
    std::vector<std::uint32_t> places;  // in the band

    explicit NodeMemory(std::size_t nodes)
        : order(nodes), zones(nodes, Zone::Outside), keys(nodes), places(nodes, kNoPlace) {
        std::iota(order.begin(), order.end(), 0U);
    }
};

class Dissector {
  public:
    Dissector(const NodeGraph& graph,
              std::span<const SolverNode> nodes,
              const Vec2& periods,
              const DissectionOptions& options,
              NodeMemory& memory)
        : graph_(graph),
          nodes_(nodes),
          periods_(periods),
          options_(options),
          memory_(memory),
          zones_(memory.zones),
          keys_(memory.keys),
          places_(memory.places) {}

    // Returns the number of the part among `parts`.
    std::size_t dissect(std::size_t begin, std::size_t end, const Box& box, int threads) {
        const Nodes part = Nodes(memory_.order).subspan(begin, end - begin);
        const int rows = rows_of(part);
        if (rows <= options_.leaf_rows) {
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
        const Half low_half{begin, begin + low, low_box};
        const Half high_half{begin + low, begin + low + high, high_box};
        const auto [left, right] = threads > 1 && rows >= kFewRows
                                       ? dissect_at_once(low_half, high_half, threads)
                                       : dissect_in_turn(low_half, high_half);
        return add_part({begin + low + high, end, left, right});
    }

    std::vector<DissectionPart> parts;

  private:
    struct Half {
        std::size_t begin = 0;
        std::size_t end = 0;
        Box box;
    };
    using BothParts = std::pair<std::size_t, std::size_t>;

    BothParts dissect_in_turn(const Half& low, const Half& high) {
        const std::size_t left = dissect(low.begin, low.end, low.box, 1);
        return {left, dissect(high.begin, high.end, high.box, 1)};
    }

    BothParts dissect_at_once(const Half& low, const Half& high, int threads) {
        Dissector other(graph_, nodes_, periods_, options_, memory_);
        const int half = threads / 2;
        parallel_for(2, 2, [&](int which) {
            if (which == 0) {
                dissect(low.begin, low.end, low.box, half);
            } else {
                other.dissect(high.begin, high.end, high.box, threads - half);
            }
        });
        const std::size_t left = parts.size() - 1;
        append(other.parts);
        return {left, parts.size() - 1};
    }

    void append(const std::vector<DissectionPart>& others) {
        const std::size_t shift = parts.size();
        for (DissectionPart part : others) {
            if (!part.is_leaf()) {
                part.left += shift;
                part.right += shift;
            }
            parts.push_back(part);
        }
    }

    std::size_t add_part(const DissectionPart& part) {
        parts.push_back(part);
        return parts.size() - 1;
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
    NodeMemory& memory_;
    std::vector<Zone>& zones_;
    std::vector<double>& keys_;
    std::vector<std::uint32_t>& places_;
    std::vector<std::uint32_t> band_;
    VertexCut cut_;
};

}  // namespace

Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads) {
    const Vec2 periods = periods_of(domain);
    const Box box = domain.is_plane() ? bounding_box(nodes) : Box{Vec2::Zero(), periods};
    NodeMemory memory(nodes.size());
    Dissector dissector(graph, nodes, periods, options, memory);
    dissector.dissect(0, nodes.size(), box, threads);
    return {std::move(memory.order), std::move(dissector.parts)};
}

}  // namespace foam
