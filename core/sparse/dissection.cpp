#include "core/sparse/dissection.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/separator.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace foam {

namespace {

// Parts with fewer rows are dissected by one thread: a second one would save next to nothing.
constexpr int kMinParallelRows = 2000;

// A rectangle around the nodes of a part, except a few that are slightly outside it.
struct Box {
    Vec2 low;
    Vec2 high;
};

// Returns the periods of the torus; for the plane, periods so large that no coordinate reaches half
// of one.
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

// One element per node. Parts of the graph that are dissected at the same time write different
// elements and read none of each other's, because a separator is between them.
struct NodeMemory {
    std::vector<std::uint32_t> order;
    std::vector<Zone> zones;
    std::vector<double> keys;                 // coordinate by which a part is halved
    std::vector<std::uint32_t> band_indices;  // for SeparatorSearch

    explicit NodeMemory(std::size_t nodes)
        : order(nodes),
          zones(nodes, Zone::Outside),
          keys(nodes),
          band_indices(nodes, SeparatorSearch::kNotInBand) {
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
          separator_(graph, nodes, options.separator, memory.zones, memory.band_indices) {}

    // Returns the index of the part in `parts`.
    std::size_t dissect(std::size_t begin, std::size_t end, const Box& box, int threads) {
        const Nodes part = Nodes(memory_.order).subspan(begin, end - begin);
        const int rows = rows_of(part);
        if (rows <= options_.leaf_rows) {
            return add_part({begin, end});
        }
        const Eigen::Index axis = box.high.x() - box.low.x() < box.high.y() - box.low.y() ? 1 : 0;
        const double cut = halve(part, box, axis);
        separator_.separate(part);
        const auto [low, high] = sort_by_zone(part);
        if (low == 0 || high == 0) {
            return add_part({begin, end});
        }
        Box low_box = box;
        Box high_box = box;
        low_box.high[axis] = high_box.low[axis] = cut;
        const Half low_half{begin, begin + low, low_box};
        const Half high_half{begin + low, begin + low + high, high_box};
        const auto [left, right] = threads > 1 && rows >= kMinParallelRows
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

    // Assigns the two halves to the zones and returns the coordinate between them. Coordinates are
    // taken relative to the middle of the box, so that one slightly beyond an edge stays near it.
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

    // Sorts the part into low nodes, high nodes and the separator, and resets their zones. Returns
    // the numbers of low and of high nodes.
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
    SeparatorSearch separator_;
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
    dissector.dissect(0, nodes.size(), box, thread_count(threads));
    return {std::move(memory.order), std::move(dissector.parts)};
}

}  // namespace foam
